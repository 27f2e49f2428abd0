// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Controllability of one state: over R, under named controls, and by Eq. (34) or (35).
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/controllability.hpp"

namespace triax::study {

/// A root of Eq. (34) or (35), with the mode that it leaves free.
struct ControlRoot {
  double R = 0;
  double angle = 0;         ///< α of its stress that unloads, rad in (π, 2π)
  double failure_rule = 0;  ///< dε₁/dσ₃ of Eq. (40) or (41), 1/Pa
};

struct Controllability {
  std::vector<sim::ControlPoint> scan;
  std::vector<sim::LostControl> lost;         ///< ranges of R between kLeastRatio and kLargestRatio
  int asked = 0, unanswered = 0;              ///< controls of that search, of both senses
  std::vector<sim::ControlIndex> named;       ///< axisymmetry only
  std::vector<sim::ControlIndex> conditions;  ///< that were asked for; axisymmetry only
  /// Whose compliance Eq. (34) or (35) is written with: that of zone (-, -) where there are
  /// zones (of INL2: with its moduli), else that of the tangent of the least direction; empty:
  /// there is none.
  std::string compliance;
  std::optional<double> symmetric_determinant;  ///< det Mˢ, 1/Pa²; below 0: two roots
  std::vector<ControlRoot> roots;               ///< by rising R
};

/// Ranges of R in which control of either sense is lost, rising and apart.
std::vector<sim::LostControl> lost_of_either_sense(const Controllability& control);

inline constexpr double kLeastRatio = 0.05, kLargestRatio = 5;

/// R from 0.1 to 3.
std::vector<double> usual_ratios();

/// `least`: the probe with the least normalised W₂. No R may be 0.
template <class Space>
Controllability control_of(const sim::IncrementalResponse<Space>& response, const sim::Probe& least,
                           const std::vector<double>& R,
                           const std::vector<sim::NamedControl>& conditions = {});

extern template Controllability control_of(const sim::IncrementalResponse<sim::Axisymmetric>&,
                                           const sim::Probe&, const std::vector<double>&,
                                           const std::vector<sim::NamedControl>&);
extern template Controllability control_of(const sim::IncrementalResponse<sim::Tensor>&,
                                           const sim::Probe&, const std::vector<double>&,
                                           const std::vector<sim::NamedControl>&);

}  // namespace triax::study
