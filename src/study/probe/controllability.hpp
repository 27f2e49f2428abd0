// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Controllability of one state: over R, under named controls, and by Eq. (34) or (35).
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/control_roots.hpp"
#include "sim/stability/controllability.hpp"

namespace triax::study {

/// A root of Eq. (34) or (35), in words.
struct NamedRoot {
  sim::ControlRoot at;
  std::string compliance;  ///< whose moduli it is a root of: "zone (-, +, -)"
};

struct Controllability {
  std::vector<sim::ControlPoint> scan;
  std::vector<sim::LostControl> lost;         ///< ranges of R between kLeastRatio and kLargestRatio
  int asked = 0, unanswered = 0;              ///< controls of that search, of both senses
  std::vector<sim::ControlIndex> named;       ///< axisymmetry only
  std::vector<sim::ControlIndex> conditions;  ///< that were asked for; axisymmetry only
  /// Whose compliance `symmetric_determinant` is that of: of the zone that holds the least W₂ where
  /// there are zones (of INL2: those of octolinear with its moduli), else of the tangent of the
  /// least direction; empty: there is none.
  std::string compliance;
  bool by_zones = false;                        ///< the roots are those of all zones
  std::optional<double> symmetric_determinant;  ///< det Mˢ, 1/Pa²
  std::vector<NamedRoot> roots;                 ///< by rising R, each of its own zone or tangent
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
