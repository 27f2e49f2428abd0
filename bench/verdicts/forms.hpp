// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The forms in which laboratories hand a record over. Each is a row of a list.
#include <span>
#include <string>
#include <string_view>

#include "bench/verdicts/simulated_test.hpp"

namespace triax::bench {

struct Form {
  std::string_view name, suffix;
  /// The text of the file; `seed` chooses what is left open (decimal mark).
  std::string (*write)(const SimulatedTest& test, std::uint64_t seed);
};

/// Raw channels with described stages; raw channels with numbered stages of which nobody says what
/// they are; the reduced table of the shear stage, without time.
std::span<const Form> forms();

}  // namespace triax::bench
