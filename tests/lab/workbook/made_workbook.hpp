// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Workbooks made for a test, part by part.
#include <zip.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/workbook/workbook.hpp"

namespace triax::lab::test {

using Parts = std::vector<std::pair<std::string, std::string>>;

/// The bytes of an archive of these parts, packed.
inline std::string zipped(const Parts& parts) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(target);
  zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  for (const auto& [name, text] : parts)
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
  zip_close(archive);
  zip_source_open(target);
  zip_stat_t status;
  zip_source_stat(target, &status);
  std::string bytes(status.size, '\0');
  zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  return bytes;
}

/// A sheet of these rows ("<row r=\"1\"><c ...").
inline std::string sheet(const std::string& rows) {
  return "<?xml version=\"1.0\"?><worksheet><sheetData>" + rows + "</sheetData></worksheet>";
}

/// Parts of a workbook with these sheets, styles 0 (number), 1 (time of day), 2 (date and time), 3
/// (date), 4 (elapsed), 5 (per cent), and these shared texts (already as <si>...</si>).
inline Parts workbook(const std::vector<std::pair<std::string, std::string>>& sheets,
                      const std::string& shared = "", const std::string& properties = "") {
  std::string names, relations;
  Parts parts{{"[Content_Types].xml", "<Types/>"}};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const auto n = std::to_string(i + 1);
    names +=
        "<sheet name=\"" + sheets[i].first + "\" sheetId=\"" + n + "\" r:id=\"rId" + n + "\"/>";
    relations += "<Relationship Id=\"rId" + n +
                 "\" Type=\"http://x/worksheet\" Target=\"worksheets/s" + n + ".xml\"/>";
    parts.emplace_back("xl/worksheets/s" + n + ".xml", sheets[i].second);
  }
  parts.emplace_back("xl/workbook.xml", "<workbook xmlns:r=\"r\"><workbookPr " + properties +
                                            "/><sheets>" + names + "</sheets></workbook>");
  parts.emplace_back(
      "xl/_rels/workbook.xml.rels",
      "<Relationships>" + relations +
          "<Relationship Id=\"a\" Type=\"http://x/sharedStrings\" Target=\"sharedStrings.xml\"/>"
          "<Relationship Id=\"b\" Type=\"http://x/styles\" "
          "Target=\"/xl/styles.xml\"/></Relationships>");
  parts.emplace_back("xl/sharedStrings.xml", "<sst>" + shared + "</sst>");
  parts.emplace_back(
      "xl/styles.xml",
      "<styleSheet><numFmts><numFmt numFmtId=\"164\" formatCode=\"dd/mm/yyyy hh:mm\"/>"
      "</numFmts><cellStyleXfs><xf numFmtId=\"14\"/></cellStyleXfs><cellXfs>"
      "<xf numFmtId=\"0\"/><xf numFmtId=\"21\"/><xf numFmtId=\"164\"/>"
      "<xf numFmtId=\"14\"/><xf numFmtId=\"46\"/><xf numFmtId=\"10\"/></cellXfs></styleSheet>");
  return parts;
}

inline std::unique_ptr<ByteSource> source_of(const Parts& parts) {
  return open_memory("m.xlsx", zipped(parts));
}

}  // namespace triax::lab::test
