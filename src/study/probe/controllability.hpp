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
  std::string compliance;  ///< whose moduli it is a root of: "zone (-, +, -)" of an octolinear law
};

struct Controllability {
  std::vector<sim::ControlPoint> scan;
  std::vector<sim::LostControl> lost;         ///< ranges of R between kLeastRatio and kLargestRatio
  int asked = 0, unanswered = 0;              ///< controls of that search, of both senses
  std::vector<sim::ControlIndex> named;       ///< axisymmetry only
  std::vector<sim::ControlIndex> conditions;  ///< that were asked for; axisymmetry only
  /// Whose compliance `symmetric_determinant` is that of, all in the least direction: the zone of
  /// an octolinear law, the tangent of others that are linear in zones, else half the Hessian of W₂
  /// (sim/stability/stability_determinant.hpp); empty: there is none.
  std::string compliance;
  std::optional<double> symmetric_determinant;  ///< det Mˢ or det H, 1/Pa²
  std::vector<NamedRoot> roots;                 ///< by rising R
  int unanswered_directions = 0;                ///< of those among which roots were sought
};

/// Ranges of R in which control of either sense is lost, rising and apart.
std::vector<sim::LostControl> lost_of_either_sense(const Controllability& control);

inline constexpr double kLeastRatio = 0.05, kLargestRatio = 5;

/// R from 0.1 to 3.
std::vector<double> usual_ratios();

/// `least`: the probe with the least normalised W₂, where the symmetric determinant is looked at;
/// not answered: neither that nor roots are sought. No R may be 0.
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
