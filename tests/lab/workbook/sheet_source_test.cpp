// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/sheet_source.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/workbook/made_workbook.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

/// The text of the first sheet.
std::string text_of(const Parts& parts) {
  const auto bytes = zipped(parts);
  const auto book = std::make_shared<const Workbook>(ZipArchive::in_memory("m.xlsx", bytes));
  SheetSource source(book, book->sheets().front(), open_memory("m.xlsx", bytes));
  std::string first;
  for (int i = 0; i < 2; ++i) {  // the same twice
    std::string text;
    char block[7];
    while (const auto count = source.read(block)) text.append(block, count);
    if (i == 0) first = text;
    CHECK(text == first);
    source.rewind();
  }
  return first;
}

std::string one_cell(const std::string& cell, const std::string& shared = "",
                     const std::string& properties = "") {
  auto text =
      text_of(workbook({{"S", sheet("<row r=\"1\">" + cell + "</row>")}}, shared, properties));
  text.pop_back();
  return text;
}

std::string fails(const Parts& parts) {
  try {
    text_of(parts);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "(nothing)";
}

std::string rows_fail(const std::string& rows) { return fails(workbook({{"S", sheet(rows)}})); }

}  // namespace

TEST_CASE("lines are rows: gaps, empty cells, rows as wide as the widest before") {
  const auto text = text_of(workbook(
      {{"S", sheet("<row r=\"2\"><c r=\"B2\"><v>1</v></c></row>"
                   "<row r=\"4\"><c r=\"A4\"><v>0.5</v></c><c r=\"D4\"><v>-1E-3</v></c></row>"
                   "<row><c><v>7</v></c><c/><c><v>8</v></c></row>"
                   "<row r=\"7\"/>")}}));
  CHECK(text == "\n,1\n\n0.5,,,-1E-3\n7,,8,\n\n\n");
}

TEST_CASE("texts: shared, rich, phonetic, inline, in quotes where they need them") {
  const std::string shared =
      "<si><t>Zeit</t></si><si><r><t>a</t></r><r><t>, b</t></r><rPh><t>x</t></rPh></si>"
      "<si><t>say \"q\"\nnow</t></si><si><t> 0,5 </t></si><si><t>1,5,0</t></si>";
  CHECK(one_cell("<c t=\"s\"><v>0</v></c>", shared) == "Zeit");
  CHECK(one_cell("<c t=\"s\"><v>1</v></c>", shared) == "\"a, b\"");
  CHECK(one_cell("<c t=\"s\"><v>2</v></c>", shared) == "\"say \"\"q\"\" now\"");
  CHECK(one_cell("<c t=\"s\"><v>3</v></c>", shared) == "0.5");
  CHECK(one_cell("<c t=\"s\"><v>4</v></c>", shared) == "\"1,5,0\"");
  CHECK(one_cell("<c t=\"inlineStr\"><is><t>-1,25</t></is></c>") == "-1.25");
  CHECK(one_cell("<c t=\"e\"><v>#DIV/0!</v></c>") == "#DIV/0!");
  CHECK(one_cell("<c t=\"e\"><f>A1</f><v>Err:522</v></c>") == "#N/A");  // a circle
}

TEST_CASE("a row that begins with # stands as in a text file") {
  CHECK(one_cell("<c t=\"inlineStr\"><is><t># name = \"a</t></is></c>"
                 "<c t=\"inlineStr\"><is><t> b\"</t></is></c>") == "# name = \"a, b\"");
}

TEST_CASE("formulas by the value of the last save; dates and clocks as text") {
  CHECK(one_cell("<c><f>1+1</f><v>2</v></c>") == "2");
  CHECK(one_cell("<c t=\"str\"><f>A2</f><v>text</v></c>") == "text");
  CHECK(one_cell("<c s=\"1\"><v>0.271111111111111</v></c>") == "06:30:24");
  CHECK(one_cell("<c s=\"2\"><v>43507.2711111111</v></c>") == "2019-02-11 06:30:24");
  CHECK(one_cell("<c s=\"3\"><v>43507</v></c>") == "2019-02-11");
  CHECK(one_cell("<c s=\"3\"><v>42045</v></c>", "", "date1904=\"1\"") == "2019-02-11");
  CHECK(one_cell("<c s=\"4\"><v>1.5</v></c>").ends_with(" 12:00:00"));
  CHECK(one_cell("<c s=\"0\"><v>43507.25</v></c>") == "43507.25");
}

TEST_CASE("what no sheet has is bad input, one line each") {
  using Catch::Contains;
  CHECK_THAT(rows_fail("<row r=\"1\"><c r=\"A1\"><f>A1</f></c></row>"),
             Contains("without a value"));
  CHECK_THAT(rows_fail("<row r=\"2\"/><row r=\"1\"/>"), Contains("rows must ascend"));
  CHECK_THAT(rows_fail("<row r=\"1048577\"/>"), Contains("rows must ascend"));
  CHECK_THAT(rows_fail("<row r=\"1\"><c r=\"XFE1\"><v>1</v></c></row>"), Contains("XFD"));
  CHECK_THAT(rows_fail("<row r=\"1\"><c r=\"ZZZZZ1\"><v>1</v></c></row>"), Contains("XFD"));
  CHECK_THAT(rows_fail("<row r=\"1\"><c r=\"B1\"><v>1</v></c><c r=\"A1\"><v>1</v></c></row>"),
             Contains("columns must ascend"));
  CHECK_THAT(rows_fail("<row r=\"1\"><c t=\"s\"><v>9</v></c></row>"),
             Contains("is not in the workbook"));
  CHECK_THAT(rows_fail("<row r=\"1\">"), Contains("XML is broken"));
  std::string wide = "<row r=\"1\">";
  for (int i = 0; i < 1'000'000; ++i) wide += "<c><v>" + std::to_string(i % 7919) + "</v></c>";
  CHECK_THAT(rows_fail(wide + "</row>"), Contains("A to XFD"));
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "<a" + std::to_string(i) + ">";
  CHECK_THAT(rows_fail(deep), Contains("nested too deep"));
  auto laughs = workbook({{"S", "<!DOCTYPE x [<!ENTITY a \"ha\">]><x>&a;</x>"}});
  CHECK_THAT(fails(laughs), Contains("document type"));
}

TEST_CASE("archives that are no workbook say what they are") {
  using Catch::Contains;
  CHECK_THAT(fails({{"a/records.xlsx", "PK"}}), Contains("unpack it"));
  CHECK_THAT(fails({{"content.xml", "<x/>"}}), Contains("OpenDocument"));
  CHECK_THAT(fails({{"[Content_Types].xml", "<x/>"}, {"word/document.xml", "<x/>"}}),
             Contains("not a workbook"));
  CHECK_THAT(
      fails(
          {{"[Content_Types].xml", "<x/>"},
           {"_rels/.rels",
            "<R><Relationship Id=\"a\" Type=\"x/officeDocument\" Target=\"xl/workbook.bin\"/></R>"},
           {"xl/workbook.bin", "\x83\x01"}}),
      Contains(".xlsb"));
  auto macros = workbook({{"S", sheet("")}});
  macros.emplace_back("xl/vbaProject.bin", "x");
  CHECK_THAT(fails(macros), Contains("macros"));
  CHECK_THAT(fails(workbook({})), Contains("no visible worksheet"));
  auto lost = workbook({{"S", sheet("")}});
  lost.erase(lost.begin() + 1);
  CHECK_THAT(fails(lost), Contains("no part"));
  CHECK_THROWS_AS(ZipArchive::in_memory("m.xlsx", "PK\3\4 and then nothing"), BadInput);
  CHECK_FALSE(looks_like_workbook(*open_memory("a.csv", "a,b\n")));
}

TEST_CASE("a bomb is not unpacked further than its 300-fold") {
  CHECK_THAT(rows_fail(std::string(std::size_t{64} << 20, ' ')), Catch::Contains("300 times"));
}

TEST_CASE("what others share does not grow beyond what a record needs") {
  using Catch::Contains;
  const auto rows = sheet("<row><c t=\"s\"><v>1</v></c></row>");
  std::string many;
  for (int i = 0; i < 60; ++i) many += "<si><t>" + std::to_string(i * 7919) + "</t></si>";
  CHECK(text_of(workbook({{"S", rows}}, many)) == "7919\n");
  // 60 MB of texts that do not pack to a 300th.
  std::uint32_t state = 1;
  many.clear();
  while (many.size() < std::size_t{60} << 20) {
    many += "<si><t>";
    for (int k = 0; k < 200; ++k) {
      state = state * 1664525 + 1013904223;
      many += std::to_string(state).append(200, 'x');
    }
    many += "</t></si>";
  }
  CHECK_THAT(fails(workbook({{"S", rows}}, many)), Contains("more than 48 MB of text"));
  CHECK_THAT(fails(workbook({{"S", rows}}, "<si><t>" + std::string(200'000, 'x') + "</t></si>")),
             Contains("too long for a spreadsheet"));
}

TEST_CASE("merged cells, a strict namespace, an encoding of its own, dates as texts of ISO 8601") {
  CHECK(text_of(workbook({{"S",
                           "<x:worksheet xmlns:x=\"http://purl.oclc.org/ooxml/spreadsheetml/main\">"
                           "<x:sheetData><x:row r=\"1\"><x:c r=\"A1\"><x:v>1</x:v></x:c>"
                           "<x:c r=\"B1\" t=\"d\"><x:v>2019-02-11T06:30:24</x:v></x:c></x:row>"
                           "<x:row r=\"2\"><x:c r=\"A2\"><x:v>2</x:v></x:c></x:row></x:sheetData>"
                           "<x:mergeCells><x:mergeCell ref=\"A1:A2\"/></x:mergeCells>"
                           "</x:worksheet>"}})) == "1,2019-02-11T06:30:24\n2,\n");
  std::string utf16 = "\xFF\xFE";
  for (const char c : "<?xml version=\"1.0\" encoding=\"UTF-16\"?>" +
                          sheet("<row><c><v>1.5</v></c></row>").substr(21)) {
    utf16 += c;
    utf16 += '\0';
  }
  CHECK(text_of(workbook({{"S", utf16}})) == "1.5\n");
}

TEST_CASE("hidden sheets are none, whichever way they are hidden") {
  const auto one = sheet("<row><c><v>1</v></c></row>");
  const auto bytes = zipped(workbook({{"Old\" state=\"hidden", one},
                                      {"Older\" state=\"veryHidden", one},
                                      {"Data\" state=\"visible", one}}));
  const Workbook book(ZipArchive::in_memory("m.xlsx", bytes));
  REQUIRE(book.sheets().size() == 1);
  CHECK(book.sheets().front().name == "Data");
  CHECK_THROWS_WITH(book.sheet("Old"), Catch::Contains("'Data'"));
  CHECK(fails(workbook({{"Old\" state=\"hidden", one}})).find("no visible worksheet") !=
        std::string::npos);
}

TEST_CASE("sheets are found by name, cells by their address") {
  const auto bytes =
      zipped(workbook({{"Tabelle", sheet("<row r=\"3\"><c r=\"B3\"><v>99.5</v></c></row>")},
                       {"Versuch01", sheet("")}}));
  const Workbook book(ZipArchive::in_memory("m.xlsx", bytes));
  CHECK(book.sheet("versuch*").name == "Versuch01");
  CHECK_THROWS_WITH(book.sheet("x"), Catch::Contains("'Tabelle', 'Versuch01'"));
  CHECK(cell_of(book, "Tabelle!B3") == "99.5");
  CHECK(cell_of(book, "Tabelle!C3").empty());
  CHECK_THROWS_AS(cell_of(book, "Tabelle!3"), BadInput);
  CHECK(is_cell_reference("Tabelle!B3"));
  CHECK_FALSE(is_cell_reference("Hoehe (cm)!"));
}

TEST_CASE("plain rows are read as the parser reads them, wherever blocks end") {
  // A blank in the tag of a cell, and the row is for the parser.
  const auto rows = [](const std::string& blank) {
    std::string text = "<row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>x</t></is></c></row>";
    for (int i = 2; i < 6000; ++i) {
      const auto n = std::to_string(i);
      text += "<row r=\"" + n + "\" spans=\"1:5\">";
      if (i % 7 != 0) text += "<c r=\"A" + n + "\"" + blank + "><v>" + n + ".25</v></c>";
      text += "<c r=\"C" + n + "\" s=\"2\"" + blank + "><f>A1+1</f><v>43507.5</v></c>";
      text += "<c r=\"AB" + n + "\" t=\"s\"" + blank + "><v>" + std::to_string(i % 2) + "</v></c>";
      if (i % 11 == 0) text += "<c" + blank + "><v>7</v></c><c s=\"1\"" + blank + "/>";
      text += i % 5 == 0 ? "</row><row/>" : "</row>";
      if (i % 5 == 0) ++i;
    }
    return sheet(text);
  };
  const std::string shared = "<si><t>a, b</t></si><si><t>0,5</t></si>";
  const auto plain = text_of(workbook({{"S", rows("")}}, shared));
  CHECK(plain == text_of(workbook({{"S", rows(" ")}}, shared)));
  CHECK(plain.find("\n2999.25,,2019-02-11 12:00:00,") != std::string::npos);
}

TEST_CASE("what only looks like a row is none") {
  const std::string row = "<row r=\"1\"><c><v>1</v></c></row>";
  const std::string other = "<row r=\"2\"><c><v>2</v></c></row>";
  CHECK(text_of(workbook({{"S", sheet(row + "<!-- " + other + " -->" + other)}})) == "1\n2\n");
  CHECK(text_of(workbook({{"S", sheet(row + "<!--</row>" + other + "-->")}})) == "1\n");
  CHECK(text_of(workbook({{"S", sheet(row + "\n " + other)}})) == "1\n2\n");
  CHECK(text_of(workbook({{"S", sheet(row + "<x:row><x:c><x:v>2</x:v></x:c></x:row>")}})) ==
        "1\n2\n");
  const std::string hidden = "<rowBreaks><![CDATA[" + other + "]]></rowBreaks>";
  CHECK(text_of(workbook({{"S", sheet(row).substr(0, sheet(row).size() - 12) + hidden +
                                    "</worksheet>"}})) == "1\n");
  // What begins as a plain row is held to the same rules.
  using Catch::Contains;
  CHECK_THAT(rows_fail(row + "<row r=\"1\"/>"), Contains("rows must ascend"));
  CHECK_THAT(rows_fail(row + "<row r=\"2\"><c r=\"XFE2\"><v>1</v></c></row>"), Contains("XFD"));
  CHECK_THAT(rows_fail(row + "<row r=\"2\"><c r=\"B3\"><v>1</v></c></row>"),
             Contains("columns must ascend"));
  CHECK_THAT(rows_fail(row + "<row r=\"2\"><c r=\"A2\"><f>A2</f></c></row>"),
             Contains("without a value"));
  CHECK_THAT(rows_fail(row + "<row r=\"2\"><c r=\"A2\" t=\"s\"><v>5</v></c></row>"),
             Contains("is not in the workbook"));
  CHECK_THAT(rows_fail(row + "<row r=\"2\"><c><v>1</c></row>"), Contains("XML is broken"));
  CHECK_THAT(rows_fail(row + "<row r=\"2\"><c><v>1</v></c>"), Contains("XML is broken"));
}

TEST_CASE("SheetSource: a truth value is a word, not a number") {
  CHECK(one_cell("<c r=\"A1\" t=\"b\"><v>1</v></c>") == "TRUE");
  CHECK(one_cell("<c r=\"A1\" t=\"b\"><v>0</v></c>") == "FALSE");
}
