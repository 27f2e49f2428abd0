// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What many tests of one soil say together.
#include <optional>
#include <string>
#include <vector>

#include "src/study/soil/power_line.hpp"
#include "src/study/soil/strength_set.hpp"
#include "src/study/soil/test_points.hpp"

namespace triax::study {

struct SoilOptions {
  FailureCriterion criterion = FailureCriterion::peak_deviator_stress;
  double failure_strain = 0.15;    ///< of the criterion axial_strain
  std::optional<double> exponent;  ///< of the power line; empty: fitted
  double stress_error_kPa = 1;     ///< of q and p′, by zeros and calibrations
  bool keep_odd = false;           ///< odd tests stay in the fits, named all the same
};

/// A trend with the tests that it rests on, by their place in Soil::tests.
struct Trend {
  LineFit line;
  std::vector<FitPoint> points;
  std::vector<std::size_t> tests;
  std::vector<FitPoint> odd_points;  ///< left out
  std::vector<std::size_t> odd_tests;
};
struct Level {
  MeanFit fit;
  std::vector<std::size_t> tests;
};

/// Stress ratio at the onset of collapse of one kind, in one direction of shear.
struct OnsetTrends {
  lab::CollapseKind kind = lab::CollapseKind::flow;
  bool extension = false;
  std::optional<Trend> over_state;       ///< ψ₀
  std::optional<Trend> over_void_ratio;  ///< e
  std::optional<Trend> over_pressure;    ///< ln(p′₀/1 kPa)
};

/// ln CSR = ln a − b ln N, so that CSR = a N^−b.
struct CyclicResistance {
  std::string criterion;  ///< "pore_pressure_ratio", "double_amplitude"
  Trend trend;            ///< over ln N
  double at_cycles(double n) const;
};

struct Soil {
  std::string group;
  std::vector<TestPoints> tests;
  std::vector<std::string> notes;      ///< what is not given and why; what is odd
  std::optional<Trend> critical_line;  ///< e over ln(p′/1 kPa)
  std::optional<PowerLine> critical_power;
  /// The form that fits the points better is the power one: states count from it.
  bool power_is_better = false;
  std::optional<Level> critical_ratio, extension_ratio;  ///< M and M_e, both positive
  std::optional<Estimate> extension_share;               ///< M_e/M
  std::optional<Level> peak_angle_deg;
  std::optional<Trend> stress_dilatancy;      ///< η at its peak over −dε_v/dε_q there
  std::optional<Trend> dilatancy_over_state;  ///< dε_v/dε_q at the peak over ψ₀
  std::optional<StrengthSet> strength;
  std::vector<OnsetTrends> onsets;
  std::optional<Trend> strength_over_state;  ///< undrained q_peak/(2 p′₀) over ψ₀
  std::vector<CyclicResistance> cyclic;
  std::optional<double> densest, loosest;

  /// e_c at p′ by the form that fits better, with the error of the line. Pre-condition: there is a
  /// line.
  Estimate critical_void_ratio(double p_eff_kPa) const;
};

/// Pre-condition: tests of one soil. A test that is in the list twice (the same file, or the same
/// states to the bit) counts once. Throws lab::BadInput where no test has a shear.
Soil study_soil(const std::vector<ShearedTest>& tests, const std::string& group,
                const SoilOptions& options = {});

}  // namespace triax::study
