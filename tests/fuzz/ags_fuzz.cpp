// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an AGS4 file: BadInput is an answer, everything else is a finding.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lab/ags/ags_reader.hpp"
#include "lab/ags/triaxial_results.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  const auto source =
      open_memory("fuzz.ags", std::string(reinterpret_cast<const char*>(data), size));
  try {
    looks_like_ags(*source);
    const AgsResults all = read_triaxial_results(*source);
    if (all.results.empty()) std::abort();
    for (const ReferenceResult& one : all.results) {
      if (!is_utf8(one.specimen.location + one.remarks)) std::abort();
      if (one.q_pa && !std::isfinite(*one.q_pa)) std::abort();
    }
  } catch (const BadInput&) {
    return 0;
  }
  return 0;
}
