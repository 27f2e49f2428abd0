// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What happens to records in laboratories: each trait is a row of a list.
#include <cstdint>
#include <span>
#include <string_view>

#include "bench/verdicts/simulated_test.hpp"

namespace triax::bench {

struct Trait {
  std::string_view name;
  /// Changes the record, and `lost` where the loss is no longer in it. False: it does not apply to
  /// this test. `seed` chooses what is left open.
  bool (*apply)(SimulatedTest& test, std::uint64_t seed);
};

std::span<const Trait> traits();

}  // namespace triax::bench
