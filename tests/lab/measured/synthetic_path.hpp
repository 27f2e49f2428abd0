// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Undrained paths in closed form: q rises to a peak and falls, p' falls throughout.
#include <cmath>
#include <random>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab::testing {

struct SyntheticPath {
  double peak_strain = 0.006, q_peak = 140e3, residual = 0.05, p_start = 300e3, p_end = 60e3;
  double strain_step = 1e-5;
  double q_noise = 0, u_noise = 0;  ///< Pa rms
  std::mt19937_64 rng{7};

  /// q/q_peak = x exp(1 − x) above the residual, x = ε₁/ε_peak: peak exactly at peak_strain.
  double q(double strain) const {
    const double x = strain / peak_strain;
    const double bump = x * std::exp(1 - x);
    return q_peak * (x < 1 ? bump : residual + (1 - residual) * bump);
  }
  double p(double strain) const {
    return p_end + (p_start - p_end) * std::exp(-strain / (2 * peak_strain));
  }
  State state(std::int64_t number) {
    const double strain = static_cast<double>(number) * strain_step;
    std::normal_distribution<double> unit(0, 1);
    State s;
    s.reading = number;
    s.time_s = static_cast<double>(number);
    s.strain = {strain, -strain / 2};
    s.volumetric_strain = 0;
    s.q = q(strain) + q_noise * unit(rng);
    s.p_eff = p(strain) + q_noise * unit(rng) / 3 + u_noise * unit(rng);
    s.pore_pressure = 500e3;
    s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};
    return s;
  }
};

inline RecordHeader undrained_header() {
  RecordHeader header;
  header.stages = {{.number = 1,
                    .name = "shear",
                    .role = StageRole::shear,
                    .drainage = Drainage::closed,
                    .control = AxialControl::displacement}};
  return header;
}

}  // namespace triax::lab::testing
