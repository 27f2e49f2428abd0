#include "sim/grains/sliding_record.hpp"

#include <algorithm>
#include <iterator>

#include "sim/grains/grain_measures.hpp"

namespace triax::sim {

void SlidingRecord::add(const GrainState& state) {
  std::vector<std::uint64_t> found;
  for (const GrainContact& c : contacts_of(state)) {
    if (!c.slides) continue;
    const auto ids = std::minmax(state.ids[c.i], state.ids[c.j]);
    found.push_back(static_cast<std::uint64_t>(ids.first) << 32U |
                    static_cast<std::uint64_t>(ids.second));
  }
  std::sort(found.begin(), found.end());
  std::vector<std::uint64_t> all;
  std::set_union(slid_.begin(), slid_.end(), found.begin(), found.end(), std::back_inserter(all));
  slid_ = std::move(all);
}

}  // namespace triax::sim
