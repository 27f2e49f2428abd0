#pragma once
// Which contacts were found at Coulomb's limit at least once.
#include <cstdint>
#include <vector>

#include "sim/grains/grain_state.hpp"

namespace triax::sim {

class SlidingRecord {
 public:
  /// Looks at a state; what it found stays.
  void add(const GrainState& state);
  /// Contacts found so far.
  std::int64_t count() const { return static_cast<std::int64_t>(slid_.size()); }

 private:
  std::vector<std::uint64_t> slid_;  // pairs of ids, ascending
};

}  // namespace triax::sim
