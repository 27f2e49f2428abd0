// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "lab/collapse/path_rates.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// The Mohr-Coulomb line η = M against which an onset is judged: from the friction angle that the
/// specimen's description gives, else the largest stress ratio that the test itself mobilised.
class LimitSurface {
 public:
  explicit LimitSurface(const SpecimenInfo& specimen);

  void add(const PathPoint& point);
  /// M in compression, unless nothing is known yet.
  std::optional<double> stress_ratio() const;
  /// Where M comes from, in words.
  std::string source() const;
  /// True if η lies strictly inside: more than 5 % below the limit, M in compression and
  /// 6 sin φ/(3 + sin φ) in extension (η < 0); that is about one degree of φ.
  bool inside(double eta) const;

 private:
  std::optional<double> given_angle_, largest_angle_;  ///< friction angles, rad
  double p_largest_ = 0;
};

}  // namespace triax::lab
