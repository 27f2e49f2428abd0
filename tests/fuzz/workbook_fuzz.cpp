// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a workbook, and as a sheet inside a sound one: BadInput is an answer, everything
// else is a finding. Packed bytes alone would never get past the archive.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"
#include "tests/lab/workbook/made_workbook.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  const bool archive = bytes.starts_with("PK");
  try {
    if (!archive) {
      const auto parts =
          test::workbook({{"S", bytes}},
                         "<si><t>axial_strain</t></si><si><t>deviator_stress_kPa</t></si>"
                         "<si><t>mean_effective_stress_kPa</t></si><si><t>0,5</t></si>");
      bytes = test::zipped(parts);
    }
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
