// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The characteristic points of one test. Stresses in kPa; in extension |q|.
#include <optional>
#include <string>
#include <vector>

#include "src/study/soil/critical_state.hpp"
#include "src/study/soil/sheared_test.hpp"

namespace triax::study {

/// A state on the way, stresses of the mean over its step.
struct TestPoint {
  double axial_strain = 0, q_kPa = 0, p_eff_kPa = 0;
  std::optional<double> void_ratio;
  double eta() const { return q_kPa / p_eff_kPa; }
};

struct TestPoints {
  std::int64_t id = 0;
  std::string name, material;
  bool used = true;
  std::string reason;  ///< why it is not used; else what is odd about it
  bool simulated = false, drained = false, extension = false;
  std::optional<double> void_ratio;  ///< at the start of shear
  std::optional<double> p_eff_kPa;   ///< p′₀
  std::optional<TestPoint> end, peak_q, peak_eta, phase_transformation;
  double peak_eta_error = 0;
  CriticalState critical;
  std::optional<Estimate> dilatancy_at_peak;  ///< dε_v/dε_q at the largest η; dilation negative
  std::optional<double> brittleness;          ///< (q_peak − least q after it)/q_peak
  std::optional<double> strength_ratio;       ///< undrained: q_peak/(2 p′₀)
  std::optional<lab::CollapseKind> collapse;
  std::optional<Estimate> onset_eta;  ///< of collapse
  std::optional<double> onset_p_eff_kPa, onset_q_kPa;
  std::optional<Estimate> state_parameter;  ///< ψ₀ = e − e_c(p′₀); set with the line
  std::optional<lab::CyclicLoading> cyclic;
  std::vector<TestPoint> path;  ///< of shear, for figures
};

/// What can be said of one test alone. The error of stresses as critical_state() has it.
TestPoints test_points(const ShearedTest& test, double stress_error_kPa = 0);

}  // namespace triax::study
