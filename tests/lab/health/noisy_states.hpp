// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Readings with noise and their states, for tests of what happens to states before assessment.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "lab/devices/noise.hpp"
#include "tests/lab/reduction/raw_record.hpp"

namespace triax::lab::testing {

/// A noisy reading of stage 3.
inline Reading noisy(std::int64_t i) {
  Reading r = reading({3, 0.001 * double(i), 0.4, 400, 300, 0}, i);
  for (std::size_t k = 0; k < 5; ++k)
    r.si[k] += 1e-4 * std::abs(r.si[k] + 1e-3) * standard_normal(1, k, std::uint64_t(i));
  return r;
}

/// A possible state with this q (Pa) that belongs to the reading.
inline State state_of(const Reading& r, double q = 100e3) {
  State s;
  s.reading = r.number;
  s.time_s = r.time_s;
  s.stage = r.stage;
  s.q = q;
  s.p_eff = std::max(100e3, q / 2);  // within what a friction angle allows
  s.strain = {1e-6 * double(r.number), 0};
  s.volumetric_strain = 0;
  s.pore_pressure = 300e3;
  return s;
}

}  // namespace triax::lab::testing
