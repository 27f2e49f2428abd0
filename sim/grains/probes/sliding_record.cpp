// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/probes/sliding_record.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/grains/state/grain_measures.hpp"

namespace triax::sim {
namespace {

/// Relative change of a normal force that is one: forces at rest wander by less.
constexpr double kChanged = 1e-4;

}  // namespace

SlidingRecord::SlidingRecord(const GrainState& start) : start_(at_limit(start)) {}

std::vector<SlidingRecord::AtLimit> SlidingRecord::at_limit(const GrainState& state) {
  std::vector<AtLimit> found;
  for (const GrainContact& c : contacts_of(state)) {
    if (!c.slides) continue;
    const auto ids = std::minmax(state.ids[c.i], state.ids[c.j]);
    found.push_back(
        {static_cast<std::uint64_t>(ids.first) << 32U | static_cast<std::uint64_t>(ids.second),
         c.normal_force_n});
  }
  std::sort(found.begin(), found.end(),
            [](const AtLimit& a, const AtLimit& b) { return a.pair < b.pair; });
  return found;
}

void SlidingRecord::add(const GrainState& state) {
  std::vector<std::uint64_t> found;
  auto before = start_.begin();
  for (const AtLimit& now : at_limit(state)) {
    while (before != start_.end() && before->pair < now.pair) ++before;
    const bool stood =
        before != start_.end() && before->pair == now.pair &&
        std::abs(now.normal_force_n - before->normal_force_n) <= kChanged * before->normal_force_n;
    if (!stood) found.push_back(now.pair);
  }
  std::vector<std::uint64_t> all;
  std::set_union(slid_.begin(), slid_.end(), found.begin(), found.end(), std::back_inserter(all));
  slid_ = std::move(all);
}

}  // namespace triax::sim
