// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/file_kind.hpp"

#include <utility>

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;
using namespace std::string_literals;

TEST_CASE("File kind: formats that are no tables are named") {
  const std::pair<std::string, std::string> kinds[] = {
      {"%PDF-1.7\n", "PDF"},
      {"\x1F\x8B\x08\0"s, "gzip"},
      {"BZh91AY&SY"s, "bzip2"},
      {"PAR1\x15"s, "Parquet"},
      {"\x89HDF\r\n\x1A\n"s, "HDF5"},
      {"SQLite format 3\0x"s, "SQLite"},
      {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s, ".xls"},
      {"\x89PNG\r\n\x1A\n"s, "PNG"},
      {"\xFF\xD8\xFF\xE0"s, "JPEG"},
      {"BM\x36\x10\x0E\0\0\0\0\0"s, "BMP"},
      {"TDSm\x0E"s, "TDMS"},
      {"MATLAB 5.0 MAT-file, Platform"s, "MATLAB"},
      {"<?xml version=\"1.0\"?><Diggs xmlns=\"http://diggsml.org/schemas/2.6\">", "DIGGS"},
      {"\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<a/>", "XML"},
      {"<?xml version=\"1.0\"?><?mso-application progid=\"Excel.Sheet\"?>", "Excel 2003"},
      {"<!DOCTYPE html><html>", "HTML"},
      {"{\n  \"readings\": []}", "JSON"},
      {"[ {\"t\": 1}]", "JSON"},
      {"[1.5, 2]", "JSON"},
      {"#GEFID = 1, 1, 0\n", "GEF"},
      {"\"**PROJ\"\n", "AGS 3"}};
  for (const auto& [bytes, name] : kinds) {
    INFO(name);
    const auto kind = find_file_kind(bytes);
    REQUIRE(kind);
    CHECK_THAT(kind->name, Catch::Contains(name));
    CHECK_FALSE(kind->remedy.empty());
  }
}

TEST_CASE("File kind: XML and JSON are known in UTF-16") {
  CHECK(find_file_kind("\xFF\xFE<\0?\0x\0m\0l\0 \0"s)->name == "an XML file");
  CHECK(find_file_kind("{\0\"\0a\0\"\0"s)->name == "a JSON file");
}

TEST_CASE("File kind: texts, AGS4 and workbooks are none of them") {
  for (const std::string& bytes :
       {""s, "a,b\n1,2\n"s, "[Data]\n1;2\n"s, "[1] 0.5 0.6\n"s, "{Triax}\n"s, "<0.1;2\n"s,
        "\"GROUP\",\"PROJ\"\n"s, "# time\n"s, "#GEO;1\n"s, "BM 12;3\n"s, "PAR;1\n"s, "** eps1 q\n"s,
        "PK\3\4\x14\0\6\0\x08\0\0\0!\0xxxxxxxxxxxx\x13\0\0\0[Content_Types].xml"s, "PK\3\4"s})
    CHECK_FALSE(find_file_kind(bytes));
}

TEST_CASE("File kind: a zip archive with other files is named with the first") {
  const auto kind = find_file_kind("PK\3\4\x14\0\0\0\x08\0\0\0!\0xxxxxxxxxxxx\x05\0\0\0a.csvdata"s);
  REQUIRE(kind);
  CHECK(kind->name == "a zip archive with 'a.csv'");
  CHECK(find_file_kind("PK\3\4\x14\0\0\0\x08\0\0\0!\0xxxxxxxxxxxx\xFF\xFF\0\0a"s));
}

TEST_CASE("File kind: the message has the kind and the remedy") {
  const auto pdf = open_memory("a.csv", "%PDF-1.7\n");
  CHECK_THROWS_WITH(refuse_other_kinds(*pdf),
                    "a.csv: this is a PDF document, not a table of readings: ask for the readings "
                    "as CSV or as a workbook (.xlsx)");
  const auto text = open_memory("a.csv", "a,b\n");
  refuse_other_kinds(*text);
  std::string first(3, ' ');
  CHECK(text->read(first) == 3);
  CHECK(first == "a,b");
}
