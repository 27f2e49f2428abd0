// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/law/law.hpp"

namespace triax::sim {

/// Of the first `mechanisms` of a law, those on whose yield surface the state stands (to within
/// kOnYield) or beyond: bit k is mechanism k.
template <class Space>
unsigned mechanisms_on_yield(const Law<Space>& law, const PointState<Space>& state,
                             int mechanisms) {
  unsigned set = 0;
  for (int k = 0; k < mechanisms; ++k)
    if (law.yield_distance(state, k) >= -kOnYield) set |= 1U << k;
  return set;
}

}  // namespace triax::sim
