// SPDX-License-Identifier: GPL-3.0-or-later
// triax export from outside: what a laboratory hands over.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

#ifndef __has_feature
#define __has_feature(x) 0
#endif

using namespace triax::cli_tests;

namespace {

/// Records of the folder that lie beside the checkout; the samples alone where there is none.
std::vector<std::filesystem::path> records() {
  std::vector<std::filesystem::path> out;
  for (const char* const folder : {"samples/records", "../shared/data"}) {
    if (!std::filesystem::exists(folder)) {
      std::cout << "skipped: no folder " << folder << '\n';
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (const auto ending = entry.path().extension();
          ending == ".csv" || ending == ".dat" || ending == ".gds")
        out.push_back(std::filesystem::absolute(entry.path()));
  }
  return out;
}

}  // namespace

TEST_CASE("a record goes out as CSV and comes back, reading by reading") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  const auto out = here.triax("export 1 --format csv --output back.csv");
  CHECK(out.status == 0);
  CHECK(out.err == "triax: wrote back.csv\n");
  REQUIRE(here.triax("replay back.csv").status == 0);
  REQUIRE(here.triax("export 1 --states --output one.csv --format csv").status == 0);
  REQUIRE(here.triax("export 2 --states --output two.csv --format csv").status == 0);
  CHECK(content(here / "one.csv") == content(here / "two.csv"));
  CHECK(content(here / "one.csv").starts_with("reading,time_s,stage,axial_strain,"));
}

TEST_CASE("no cell of an exported CSV is a formula to a spreadsheet") {
  const Workplace here;
  write(here / "evil.csv",
        "# [test]\n# name = \"a, =1+1;@x\\t-2|+3\"\n# [specimen]\n# material = \"=HYPERLINK(1)\"\n"
        "axial_strain,deviator_stress_kPa,mean_effective_stress_kPa\n0,0,100\n0.1,5,101\n0.2,-9,"
        "103\n");
  REQUIRE(here.triax("replay evil.csv").status == 0);
  for (const std::string states : {"", " --states"}) {
    REQUIRE(here.triax("export 1 --format csv --output out.csv" + states).status == 0);
    std::string cell;
    for (const char c : content(here / "out.csv") + "\n") {
      if (std::string(",;|\t\r\n").find(c) == std::string::npos) {
        cell += c;
        continue;
      }
      const auto begin = cell.find_first_not_of(" \"");
      if (begin != std::string::npos) {
        const bool formula = std::string("=+-@").find(cell[begin]) != std::string::npos;
        char* end = nullptr;
        std::strtod(cell.c_str(), &end);
        INFO(cell);
        CHECK((!formula || *end == 0));
      }
      cell.clear();
    }
  }
  REQUIRE(here.triax("export 1 --format csv --output back.csv").status == 0);
  REQUIRE(here.triax("replay back.csv").status == 0);
  const auto report = nlohmann::json::parse(here.triax("report 2 --format json").out);
  CHECK(report["test"]["name"] == "a, =1+1;@x\t-2|+3");
}

TEST_CASE("JSON holds the report with readings and states") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  const auto out = here.triax("export --format json");
  CHECK(out.status == 0);
  const auto document = nlohmann::json::parse(out.out);
  const auto report = nlohmann::json::parse(here.triax("report --format json").out);
  CHECK(document["collapse"] == report["collapse"]);
  CHECK(document["readings"]["columns"][0] == "time_s");
  CHECK(document["states"]["rows"].size() == 3280);
  CHECK(document["states"]["rows"][0].size() == document["states"]["columns"].size());
}

TEST_CASE("every record goes out as AGS4 without a finding, ours or python-ags4's") {
  const Workplace here;
  for (const auto& record : records()) {
    INFO(record);
    const auto replayed =
        here.triax("replay '" + record.string() + "' --set specimen.height_mm=100 " +
                   "--set specimen.diameter_mm=50");
    // Files of others are there in forms that replay does not read yet.
    if (record.string().find("samples/records") != std::string::npos) CHECK(replayed.status == 0);
  }
  const auto out = here.triax("export --format ags --output all.ags");
  CHECK(out.status == 0);
  CHECK(here.triax("export --check all.ags").status == 0);
  // Only results are read back, of what was exported as they were.
  CHECK(here.triax("replay all.ags").status == 0);
  const std::string checker = "../shared/tools/ags4check";
  if (!std::filesystem::exists(checker) ||
      std::system("/usr/bin/python3 -c 'import pandas, rich' 2>/dev/null") != 0) {
    std::cout << "skipped: no python-ags4 beside the checkout\n";
    return;
  }
  CHECK(std::system((checker + " '" + (here / "all.ags").string() + "' >/dev/null").c_str()) == 0);
}

TEST_CASE("what cannot be exported is one line and status 2") {
  const Workplace here;
  REQUIRE(here.triax("replay " + source("samples/records/icu_6.csv")).status == 0);
  write(here / "broken.ags", "\"GROUP\",\"PROJ\"\r\n");
  for (const char* const arguments :
       {"export 1", "export 1 --output x.doc", "export 1 --format csv --set LOCA_ID=1",
        "export 1 --format ags --set LOCA_XX=1", "export 1 --format ags --set SAMP_TOP=deep",
        "export 1 --format json --states", "export 1 --format csv --output triax.db",
        "export 7 --format csv", "export 1 --format csv --output -", "export --check none.ags"}) {
    const auto out = here.triax(arguments);
    INFO(arguments << '\n' << out.err);
    CHECK(out.status == 2);
    CHECK(std::count(out.err.begin(), out.err.end(), '\n') == 1);
  }
  CHECK(here.triax("export --check broken.ags").status == 2);
  CHECK_FALSE(here.has("LOCA"));
}

TEST_CASE("workbooks: one a test, readings that come back as the same test, nothing half") {
  const Workplace here;
  for (const char* const record : {"icu_6", "csd_58"})
    REQUIRE(
        here.triax("replay " + source("samples/records/" + std::string(record) + ".csv")).status ==
        0);
  const auto one = here.triax("export 1 --output one.xlsx");
  CHECK(one.status == 0);
  CHECK(one.err == "triax: wrote one.xlsx\n");
  CHECK(content(here / "one.xlsx").starts_with("PK"));
  std::filesystem::create_directory(here / "all");
  CHECK(here.triax("export --format xlsx --output all").status == 0);
  CHECK(here.has("all/ICU_6.xlsx"));
  CHECK(here.has("all/CSD_58.xlsx"));
  REQUIRE(here.triax("replay one.xlsx").status == 0);
  const auto before = nlohmann::json::parse(here.triax("report 1 --format json").out);
  const auto after = nlohmann::json::parse(here.triax("report 3 --format json").out);
  CHECK(after["test"]["origin"] == "simulated");
  CHECK(after["collapse"]["kind"] == before["collapse"]["kind"]);
  CHECK(after["test"]["readings"] == before["test"]["readings"]);
  for (const char* const arguments :
       {"export --output two.xlsx", "export 1 --format xlsx --output -",
        "export 1 --format xlsx --states", "export 1 --format xlsx --output triax.db",
        "export 1 --output nowhere/one.xlsx"}) {
    const auto out = here.triax(arguments);
    INFO(arguments << '\n' << out.err);
    CHECK(out.status != 0);
    CHECK(std::count(out.err.begin(), out.err.end(), '\n') == 1);
  }
  CHECK_FALSE(here.has("two.xlsx"));
}

TEST_CASE("spoiled workbooks are one line, status 2, in little memory") {
  const Workplace here;
  const std::string make =
      "import sys, zipfile\n"
      "book = '<workbook xmlns:r=\"r\"><sheets><sheet name=\"S\" "
      "r:id=\"a\"/></sheets></workbook>'\n"
      "rels = '<R><Relationship Id=\"a\" Type=\"x/worksheet\" Target=\"s.xml\"/></R>'\n"
      "def made(name, sheet, more=()):\n"
      "    with zipfile.ZipFile(name, 'w', zipfile.ZIP_DEFLATED) as z:\n"
      "        for part, text in [('[Content_Types].xml', '<T/>'), ('xl/workbook.xml', book),\n"
      "                           ('xl/_rels/workbook.xml.rels', rels), *more]: z.writestr(part, "
      "text)\n"
      "        if sheet is not None:\n"
      "            with z.open('xl/s.xml', 'w', force_zip64=True) as f:\n"
      "                for piece in sheet: f.write(piece)\n"
      "head, tail = b'<worksheet><sheetData>', b'</sheetData></worksheet>'\n"
      "made('bomb.xlsx', [b' ' * (1 << 20)] * 1000)\n"
      "row = b'<row><c><v>1</v></c></row>' * 40000\n"
      "made('rows.xlsx', [head] + [row] * 1000)\n"
      "made('columns.xlsx', [head, b'<row r=\"1\">'] + [b'<c><v>%d</v></c>' % (i * 7919) for i in "
      "range(1000000)])\n"
      "made('circle.xlsx', [head, b'<row r=\"1\"><c r=\"A1\"><f>B1</f></c><c "
      "r=\"B1\"><f>A1</f></c></row>', tail])\n"
      "made('missing.xlsx', None)\n"
      "made('macros.xlsx', [head, tail], [('xl/vbaProject.bin', 'x')])\n"
      "with zipfile.ZipFile('nested.xlsx', 'w') as z: z.write('circle.xlsx')\n"
      "made('broken.xlsx', [head, b'<row r=\"1\"><c r=\"A1\"><v>1</v></c></row>' * 3, tail])\n"
      "data = open('circle.xlsx', 'rb').read()\n"
      "open('cut.xlsx', 'wb').write(data[:len(data) // 2])\n";
  write(here / "make.py", make);
  REQUIRE(std::system(("cd '" + (here / "").string() + "' && python3 make.py").c_str()) == 0);
  for (const char* const name :
       {"bomb", "rows", "columns", "circle", "missing", "macros", "nested", "broken", "cut"}) {
    const auto out = here.triax("replay " + std::string(name) + ".xlsx");
    INFO(name << ": " << out.err);
    CHECK(out.status == 2);
    CHECK(std::count(out.err.begin(), out.err.end(), '\n') == 1);
  }
#if !defined(__SANITIZE_ADDRESS__) && !__has_feature(address_sanitizer)  // which takes its own
  // A gigabyte that is packed costs no more memory than a record does.
  for (const char* const name : {"bomb", "rows", "columns"})
    CHECK(std::system(("cd '" + (here / "").string() +
                       "' && /usr/bin/time -f %M -o kB " TRIAX_PROGRAM " replay " + name +
                       ".xlsx >/dev/null 2>&1; test $(tail -n 1 kB) -lt 100000")
                          .c_str()) == 0);
#endif
}
