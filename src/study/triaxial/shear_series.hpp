// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The shear of several tests, to be compared with one another.
#include <optional>
#include <string>
#include <vector>

#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"
#include "src/study/triaxial/line_breaks.hpp"
#include "src/study/triaxial/tests_origin.hpp"

namespace triax::study {

/// True for a stage of shear, and where the record does not say what the stage was.
bool is_shear(const lab::RecordHeader& header, int stage);

/// Of a shear with these states. Closed where every stage of them whose drainage is known was
/// closed: one that was open for a while has another void ratio. Where the record does not say it,
/// what moved does: closed where ε_v moves by a thousandth at most, or is not known. Unknown
/// without states.
lab::Drainage drainage_of_shear(const lab::RecordHeader& header,
                                const std::vector<lab::State>& states);

/// The state nearest to that instant by its reading; nothing without one.
std::optional<lab::State> nearest_state(const std::vector<lab::State>& states,
                                        const std::optional<lab::Instant>& instant);

struct SeriesTest {
  std::string name;
  std::vector<lab::State> states;     ///< of shear, in order
  LineBreaks breaks{};                ///< of lines through them
  std::optional<lab::Instant> onset;  ///< of instability
  std::optional<lab::Instant> loss_of_control{};
  /// The nearest to each among `states`; nothing without that instant or without states.
  std::optional<lab::State> at_onset{}, at_loss_of_control{};
};

struct ShearSeries {
  std::vector<SeriesTest> tests;
  /// Largest axial strain at an onset of collapse; 0 without one.
  double strain_at_onset = 0;
  std::vector<double> instability_lines;    ///< η of compression, of extension
  std::vector<double> limit_stress_ratios;  ///< M, rising
  TestsOrigin origin;
};

/// All of shear, from the curves of the tests.
ShearSeries shear_series(const std::vector<TestResult>& tests);

/// Shear up to an axial strain at which a collapse, if there is one, is well under way.
struct ShearBeginnings {
  ShearSeries series;
  /// Some times the largest axial strain at an onset; at most, and without an onset, the largest
  /// strain of all states.
  double last_strain = 0;
};

/// Each test up to its first state beyond that strain.
ShearBeginnings shear_beginnings(const std::vector<TestResult>& tests);

}  // namespace triax::study
