// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a record file: BadInput is an answer, everything else is a finding.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  std::string bytes(size, '\0');
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(data[i]);
  try {
    const auto rig = open_record(open_memory("fuzz", std::move(bytes)), {});
    Reading reading;
    double last = -HUGE_VAL;
    while (rig->next(reading)) {
      if (rig->header().has_time && !(reading.time_s > last)) std::abort();
      last = reading.time_s;
      for (const double value : reading.si)
        if (std::isinf(value)) std::abort();
    }
  } catch (const BadInput&) {
    return 0;
  }
  return 0;
}
