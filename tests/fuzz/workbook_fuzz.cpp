// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a workbook, and as one part of a sound one: a sheet, or by a first byte of 1 to 4
// its shared texts, styles, list of sheets, relations. BadInput is an answer, everything else is a
// finding. Packed bytes alone would never get past the archive.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"
#include "tests/fuzz/archive_around.hpp"

using namespace triax::lab;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    if (!bytes.starts_with("PK")) bytes = test::archive_around(std::move(bytes));
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
