// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a workbook, and as one part of a sound one: a sheet, or by a first byte of 1 to 4
// its shared texts, styles, list of sheets, relations. BadInput is an answer, everything else is a
// finding. Packed bytes alone would never get past the archive.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"
#include "tests/lab/workbook/made_workbook.hpp"

namespace {

using namespace triax::lab;

/// A sound workbook around the bytes.
std::string archive_around(std::string bytes) {
  constexpr const char* kParts[] = {"xl/sharedStrings.xml", "xl/styles.xml", "xl/workbook.xml",
                                    "xl/_rels/workbook.xml.rels"};
  const std::string sound =
      "<worksheet><sheetData><row><c t=\"s\"><v>0</v></c><c t=\"s\"><v>1</v></c>"
      "<c t=\"s\"><v>2</v></c></row><row><c s=\"1\"><v>0.25</v></c><c s=\"2\"><v>20</v></c>"
      "<c t=\"s\"><v>3</v></c></row></sheetData></worksheet>";
  const auto part = static_cast<unsigned char>(bytes.empty() ? 0 : bytes.front());
  const bool of_book = part >= 1 && part <= std::size(kParts);
  if (of_book) bytes.erase(0, 1);
  auto parts = test::workbook({{"S", of_book ? sound : bytes}},
                              "<si><t>axial_strain</t></si><si><t>deviator_stress_kPa</t></si>"
                              "<si><t>mean_effective_stress_kPa</t></si><si><t>0,5</t></si>");
  if (of_book)
    for (auto& [name, text] : parts)
      if (name == kParts[part - 1]) text = std::move(bytes);
  return test::zipped(parts);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    if (!bytes.starts_with("PK")) bytes = archive_around(std::move(bytes));
    const auto rig = open_record(open_memory("fuzz.xlsx", std::move(bytes)), {});
    Reading reading;
    while (rig->next(reading))
      for (const double value : reading.si)
        if (std::isinf(value)) std::abort();
  } catch (const BadInput&) {
    return 0;
  }
  return 0;
}
