// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An undrained test in closed form whose stiffness goes with √p′ and falls linearly over η, to zero
// at η*:
//
//   p′ = p₀ (1 − η/2η*),   q = η p′,   ε₁ = 4 η* k (1 − √(1 − η/2η*))
//   =>  dq/dε₁ = (p₀/k) √(p′/p₀) (1 − η/η*),   dp′/dε₁ = −(p₀/2η*k) √(p′/p₀)
//
// so that q peaks, and second-order work vanishes, at η = η* with q* = p₀ η*/2.
#include <cmath>
#include <random>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab::testing {

struct LoosePath {
  double eta_onset = 0.6, p0_pa = 1e5, strain_per_eta = 0.006;
  double noise_pa = 0;      ///< rms of q and of p′
  double noise_strain = 0;  ///< rms of ε₁
  double interval_s = 1;
  std::mt19937 random{7};

  /// The state at that η.
  State at(double eta, int reading) {
    std::normal_distribution<double> normal;
    State s;
    s.reading = reading;
    s.time_s = reading * interval_s;
    s.stage = 1;
    s.p_eff = p0_pa * (1 - eta / (2 * eta_onset));
    s.q = eta * s.p_eff + noise_pa * normal(random);
    s.p_eff += noise_pa * normal(random);
    s.volumetric_strain = 0;
    const double bent = 1 - std::sqrt(1 - eta / (2 * eta_onset));
    const double axial = 4 * eta_onset * strain_per_eta * bent + noise_strain * normal(random);
    s.strain = {axial, -axial / 2};
    s.pore_pressure = 4e5 - s.p_eff + s.q / 3;
    return s;
  }
  /// η under a load that grows steadily to q* at `share` = 1.
  double eta_under_load(double share) const { return eta_onset * (1 - std::sqrt(1 - share)); }
};

inline RecordHeader shear_header(AxialControl control, Drainage drainage = Drainage::closed) {
  RecordHeader header;
  header.has_time = true;
  header.specimen.limit_friction_angle_rad = 32.0 / 180 * 3.14159265358979;
  header.stages = {StageInfo{.number = 1,
                             .name = "shear",
                             .role = StageRole::shear,
                             .drainage = drainage,
                             .control = control,
                             .strain_path_R = {}}};
  return header;
}

}  // namespace triax::lab::testing
