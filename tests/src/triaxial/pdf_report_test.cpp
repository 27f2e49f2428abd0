// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/pdf_report.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lab/base/bad_input.hpp"
#include "tests/src/sample_sheets.hpp"

using namespace triax;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::size_t pages(const std::string& pdf) {
  std::size_t n = 0;
  for (auto at = pdf.find("/Type /Page\n"); at != std::string::npos;
       at = pdf.find("/Type /Page\n", at + 1))
    ++n;
  return n;
}

}  // namespace

TEST_CASE("a PDF appears whole, with more pages for more tests") {
  const auto folder = std::filesystem::temp_directory_path() / "triax_pdf_report_test";
  std::filesystem::create_directories(folder);
  src::pdf_report(src::test::sheets_of({src::test::stable_test()}), (folder / "one.pdf").string());
  src::pdf_report(src::test::sheets_of({src::test::flow_test(), src::test::simulated_test(),
                                        src::test::stable_test()}),
                  (folder / "three.pdf").string());
  const std::string one = content(folder / "one.pdf"), three = content(folder / "three.pdf");
  CHECK(one.rfind("%PDF-1.", 0) == 0);
  CHECK(one.find("%%EOF") != std::string::npos);
  CHECK(one.find("CreationDate") == std::string::npos);  // the same report, the same bytes
  CHECK(pages(one) == 1);
  CHECK(pages(three) == 4);  // and one of the set
  CHECK(pages(src::pdf_bytes(src::test::sheets_of({src::test::flow_test()}, true))) > 2);
  CHECK_THROWS_AS(src::pdf_report(src::test::sheets_of({src::test::stable_test()}),
                                  (folder / "no/where.pdf").string()),
                  lab::BadInput);
  CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 2);
  std::filesystem::remove_all(folder);
}
