// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the loops over pairs take, for tests that call them directly.
#include <cstdint>
#include <cstring>

#include "sim/grains/engine/kernels.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim::test {

/// All near pairs of a state.
inline PairRange range_of(GrainState& s, AlignedVector<GrainLoad>& loads) {
  NearPairs& near = s.neighbours.near;
  PairRange r{};
  r.grains = s.grains.data();
  r.loads = loads.data();
  r.end = static_cast<std::int64_t>(near.size());
  r.i = near.i.data();
  r.j = near.j.data();
  r.tx = near.tangential_n[0].data();
  r.ty = near.tangential_n[1].data();
  r.tz = near.tangential_n[2].data();
  r.stiffness = near.stiffness_n_per_m.data();
  r.reach = near.reach_m.data();
  r.half_difference = near.half_difference_m.data();
  r.friction_coefficient = 0.3;
  r.tangential_step = 0.42e-6;
  r.half_step = 0.5e-6;
  return r;
}

inline bool same_bytes(const auto& a, const auto& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

}  // namespace triax::sim::test
