// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scans for the tests of this folder: plausible ones, and ones that follow from nothing.
#include <cstring>
#include <random>
#include <utility>

#include "lab/results/reading.hpp"
#include "lab/results/state.hpp"

namespace triax::testing {

inline constexpr double kVoidRatio = 0.885;
inline constexpr double kArea = 0.0038484510006474966;

inline bool same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0;
}

inline bool same(const lab::Reading& a, const lab::Reading& b) {
  bool equal = a.number == b.number && a.stage == b.stage && same(a.time_s, b.time_s);
  for (std::size_t i = 0; i < lab::kQuantityCount; ++i) equal = equal && same(a.si[i], b.si[i]);
  return equal;
}

inline bool same(const lab::State& a, const lab::State& b) {
  return a.reading == b.reading && a.stage == b.stage && same(a.time_s, b.time_s) &&
         same(a.strain.axial, b.strain.axial) && same(a.strain.radial, b.strain.radial) &&
         same(a.volumetric_strain, b.volumetric_strain) && same(a.void_ratio, b.void_ratio) &&
         same(a.area_m2, b.area_m2) && same(a.effective_stress.axial, b.effective_stress.axial) &&
         same(a.effective_stress.radial, b.effective_stress.radial) &&
         same(a.pore_pressure, b.pore_pressure) && same(a.p_eff, b.p_eff) && same(a.q, b.q);
}

/// What a logger writes (decimals in units of the field) and what a right cylinder makes of it.
inline std::pair<lab::Reading, lab::State> raw_scan(std::mt19937_64& random, std::int64_t number) {
  using lab::Quantity;
  std::uniform_int_distribution<int> digits(0, 999999);
  const auto decimal = [&](double step, double offset) { return offset + digits(random) * step; };
  lab::Reading r;
  r.number = number;
  r.time_s = static_cast<double>(number) * 0.1;
  r[Quantity::axial_displacement] = decimal(1e-5, 0) * 1e-3;
  r[Quantity::axial_force] = decimal(1e-6, 0) * 1e3;
  r[Quantity::cell_pressure] = decimal(1e-4, 750) * 1e3;
  r[Quantity::back_pressure] = 500.0 * 1e3;
  r[Quantity::pore_pressure] = decimal(1e-4, 500) * 1e3;
  r[Quantity::back_volume] = (digits(random) - 500000) * 1e-2 * 1e-9;
  lab::State s;
  s.reading = number;
  s.time_s = r.time_s;
  s.strain.axial = r[Quantity::axial_displacement] / 0.14;
  s.volumetric_strain = -r[Quantity::back_volume] / (kArea * 0.14);
  s.strain.radial = (s.volumetric_strain - s.strain.axial) / 2;
  s.void_ratio = kVoidRatio - s.volumetric_strain * (1 + kVoidRatio);
  s.area_m2 = kArea * ((1 - s.volumetric_strain) / (1 - s.strain.axial));
  s.q = r[Quantity::axial_force] / s.area_m2;
  s.pore_pressure = r[Quantity::pore_pressure];
  s.effective_stress.radial = r[Quantity::cell_pressure] - s.pore_pressure;
  s.effective_stress.axial = r[Quantity::cell_pressure] + s.q - s.pore_pressure;
  s.p_eff = sim::mean_stress(s.effective_stress);
  return {r, s};
}

/// A state whose every value is unrelated to the others and to the reading.
inline lab::State wild_state(std::mt19937_64& random, const lab::Reading& reading) {
  std::normal_distribution<double> any(0, 1e5);
  lab::State s;
  s.reading = reading.number;
  s.time_s = reading.time_s;
  s.stage = reading.stage;
  for (double* value :
       {&s.strain.axial, &s.strain.radial, &s.volumetric_strain, &s.void_ratio, &s.area_m2,
        &s.effective_stress.axial, &s.effective_stress.radial, &s.pore_pressure, &s.p_eff, &s.q})
    *value = any(random);
  if (random() % 2 == 0) s.void_ratio = lab::kMissing;
  return s;
}

}  // namespace triax::testing
