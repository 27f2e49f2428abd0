// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <iterator>
#include <string>
#include <utility>

#include "tests/lab/workbook/made_workbook.hpp"

namespace triax::lab::test {

/// A sound workbook around the bytes: a sheet, or by a first byte of 1 to 4 its shared texts,
/// styles, list of sheets, relations.
inline std::string archive_around(std::string bytes) {
  constexpr const char* kParts[] = {"xl/sharedStrings.xml", "xl/styles.xml", "xl/workbook.xml",
                                    "xl/_rels/workbook.xml.rels"};
  const std::string sound =
      "<worksheet><sheetData><row><c t=\"s\"><v>0</v></c><c t=\"s\"><v>1</v></c>"
      "<c t=\"s\"><v>2</v></c></row><row><c s=\"5\"><v>0.25</v></c><c><v>20</v></c>"
      "<c t=\"s\"><v>3</v></c></row></sheetData></worksheet>";
  const auto part = static_cast<unsigned char>(bytes.empty() ? 0 : bytes.front());
  const bool of_book = part >= 1 && part <= std::size(kParts);
  if (of_book) bytes.erase(0, 1);
  auto parts = workbook({{"S", of_book ? sound : bytes}},
                        "<si><t>axial_strain</t></si><si><t>deviator_stress_kPa</t></si>"
                        "<si><t>mean_effective_stress_kPa</t></si><si><t>0,5</t></si>");
  if (of_book)
    for (auto& [name, text] : parts)
      if (name == kParts[part - 1]) text = std::move(bytes);
  return zipped(parts);
}

}  // namespace triax::lab::test
