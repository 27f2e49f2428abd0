// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/figure_files.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lab/base/bad_input.hpp"
#include "src/probe/figures/circular_diagram.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;
namespace fs = std::filesystem;

namespace {

/// A folder of its own that goes with the test.
struct Folder {
  Folder() {
    std::string name = (fs::temp_directory_path() / "triax-figures-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the test");
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string in(const std::string& name) const { return (path / name).string(); }
  fs::path path;
};

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Drawing diagram() {
  return circular_diagram({{"η = 0.60", test::inl2_circle(0.6)}}, test::subject());
}

FigureData table() {
  return {"W₂ \"around\" a state",
          "simulated",
          {"inl2/S28-general", "p′ = 70 kPa\nη = 0.6"},
          {{"alpha_deg", "°"}, {"w2_normalised", ""}},
          {{0, 0.25}, {10, std::nullopt}, {20, std::nan("")}}};
}

}  // namespace

TEST_CASE("a figure is three files, whole, with its caption in each") {
  const Folder folder;
  const auto paths = write_figure(diagram(), folder.in("circle"));
  REQUIRE(paths == std::vector<std::string>{folder.in("circle.svg"), folder.in("circle.png"),
                                            folder.in("circle.pdf")});
  const auto svg = content(paths[0]), png = content(paths[1]), pdf = content(paths[2]);
  CHECK(svg.rfind("<?xml", 0) == 0);
  CHECK(test::contains(svg, "<desc>Circular diagram"));
  CHECK(test::contains(svg, "W₂ &lt; 0"));
  CHECK(test::contains(svg, "</svg>"));
  CHECK_FALSE(test::contains(svg, "nan"));
  CHECK(png.rfind("\x89PNG", 0) == 0);
  CHECK(test::contains(png, "Description"));
  CHECK(test::contains(png, "IEND"));
  CHECK(pdf.rfind("%PDF", 0) == 0);
  CHECK(test::contains(pdf, "/Title"));
  CHECK(test::contains(pdf, "%%EOF"));
  CHECK(svg.size() + png.size() + pdf.size() < 600000);
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 3);
}

TEST_CASE("a picture has two pixels a CSS pixel, a page the size of the drawing in points") {
  const auto drawing = diagram();
  const auto image = QImage::fromData(QByteArray::fromStdString(to_png(*drawing.plot, 2)));
  CHECK(image.size() == drawing.plot->size() * 2);
  CHECK(test::contains(to_pdf(drawing), "/MediaBox [0 0 465.000000 531"));
}

TEST_CASE("the same drawing gives the same bytes, at any time") {
  const Folder folder;
  const auto first = write_figure(diagram(), folder.in("a"));
  const auto second = write_figure(diagram(), folder.in("b"));
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(content(first[i]) == content(second[i]));
  CHECK_FALSE(test::contains(content(first[2]), "CreationDate"));
}

TEST_CASE("make_reproducible: times and identifiers become spaces") {
  const std::string before =
      "/CreationDate (D:20261127) /ModDate (D:20261127) <r xmp:CreateDate=\"2026\" "
      "xmp:ModifyDate=\"2026\" xmp:MetadataDate=\"2026\" xmpMM:DocumentID=\"uuid:1\" "
      "xmpMM:VersionID=\"1\"/> /ID [ <61> <61> ] startxref 94";
  const std::string after = make_reproducible(before);
  CHECK(after.size() == before.size());
  for (const char* gone : {"2026", "uuid", "/ID"}) CHECK_FALSE(test::contains(after, gone));
  CHECK(test::contains(after, "xmpMM:VersionID=\"1\"/>"));
  CHECK(after.ends_with(" startxref 94"));
  CHECK(make_reproducible("no variable part (") == "no variable part (");
}

TEST_CASE("a file in the way that is none is bad input, a missing folder work that failed") {
  const Folder folder;
  fs::create_directory(folder.in("a.png"));
  CHECK_THROWS_AS(write_figure(diagram(), folder.in("a")), lab::BadInput);
  CHECK_THROWS_AS(write_figure(diagram(), folder.in("no/such")), lab::BadInput);
  CHECK_THROWS_AS(write_figure_data(table(), folder.in("no/such")), lab::BadInput);
  CHECK_FALSE(fs::exists(folder.in("a.pdf")));
}

TEST_CASE("CSV: remarks, units, one line of names, empty where unknown") {
  CHECK(to_csv(table()) ==
        "# W₂ \"around\" a state\n# origin = \"simulated\"\n# inl2/S28-general\n"
        "# p′ = 70 kPa η = 0.6\n# alpha_deg in °\nalpha_deg,w2_normalised\n"
        "0,0.25\n10,\n20,\n");
}

TEST_CASE("JSON: the same table, null where unknown, whatever is in the words") {
  const auto document = nlohmann::json::parse(to_json(table()));
  CHECK(document["title"] == "W₂ \"around\" a state");
  CHECK(document["origin"] == "simulated");
  CHECK(document["remarks"].size() == 2);
  CHECK(document["columns"][0]["unit"] == "°");
  REQUIRE(document["rows"].size() == 3);
  CHECK(document["rows"][0][1] == 0.25);
  CHECK(document["rows"][1][1].is_null());
  CHECK(document["rows"][2][1].is_null());
  auto empty = table();
  empty.rows.clear();
  CHECK(nlohmann::json::parse(to_json(empty))["rows"].empty());
}

TEST_CASE("the data stand beside the figure in two files") {
  const Folder folder;
  const auto paths = write_figure_data(table(), folder.in("circle"));
  REQUIRE(paths.size() == 2);
  CHECK(content(paths[0]) == to_csv(table()));
  CHECK(content(paths[1]) == to_json(table()));
}
