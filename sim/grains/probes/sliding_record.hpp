// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which contacts slid since a state.
#include <cstdint>
#include <vector>

#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// A contact slid if it is found at Coulomb's limit and was not so before, or its normal force has
/// changed meanwhile: what stays at the limit while its load changes has to slip. In a specimen at
/// rest many contacts stand at their limit without moving; they do not count.
class SlidingRecord {
 public:
  explicit SlidingRecord(const GrainState& start);
  /// Looks at a state; what it found stays.
  void add(const GrainState& state);
  /// Contacts found so far.
  std::int64_t count() const { return static_cast<std::int64_t>(slid_.size()); }

 private:
  struct AtLimit {
    std::uint64_t pair = 0;  // of ids
    double normal_force_n = 0;
  };
  static std::vector<AtLimit> at_limit(const GrainState& state);

  std::vector<AtLimit> start_;       // ascending in pair
  std::vector<std::uint64_t> slid_;  // ascending
};

}  // namespace triax::sim
