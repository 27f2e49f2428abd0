// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the best forecast could have said at a tenth of the stage left, chosen with the truth: how
// much the readings hold of an onset to come.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/warning/alarm_trial.hpp"
#include "lab/warning/driven_path.hpp"

namespace triax::bench {

/// Extrapolations of what was read: windows that reach back kReaches times the true distance that
/// is left, dy/dx linear or quadratic over η, and what is continued to zero (dy/dx, the slope of
/// the stress path, normalised work). η of each; empty where it has no root.
using Members = std::vector<std::optional<double>>;

/// Follows a test up to a tenth left of the stage of its onset.
class Hindsight {
 public:
  static constexpr std::array kReaches = {1.3, 1.6, 2.5, 4.0, 6.5};
  explicit Hindsight(const AlarmTest& test);
  lab::SessionListener listener();
  Members members() const;

 private:
  const AlarmTest& test_;
  double then_s_;
  std::optional<int> stage_;
  lab::SpecimenVolume volume_;
  lab::DrivenPath path_;
};

}  // namespace triax::bench
