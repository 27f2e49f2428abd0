// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is said of a state that was probed, whatever the probes were.
#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "src/study/probe/state_to_probe.hpp"

namespace triax::study {

struct StateHead {
  std::string name;
  bool from_path = false;
  std::optional<double> axial_strain;
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();  ///< σ′ along axes 1 to 3, Pa
  double p = 0, q = 0;                               ///< Pa; q as deviator_stress() has it
  double void_ratio = 0;
  std::vector<std::pair<std::string, double>> memory;
  std::optional<TestedState> test;
  std::vector<std::string> warnings;  ///< of the law and of the test
  /// That the state lies outside what the material's numbers are for; empty: it does not.
  std::optional<std::string> void_ratio_outside, p_eff_outside;

  double eta() const { return q / p; }
  std::vector<std::string> all_warnings() const;
};

/// Each warning once; of states outside the range the first, and how many there are.
std::vector<std::string> warnings_of(const std::vector<const StateHead*>& states);

/// Throws lab::BadInput with the law's words where it refuses the state. Pre-condition: the
/// material has a law in this space.
template <class Space>
StateHead head_of(const lab::MaterialSet& material, const StateToProbe<Space>& what);

/// q = ± √(3/2)|s| with the sign of σ₁′ − (σ₂′ + σ₃′)/2, Pa: positive while axis 1 carries more
/// than the mean of the other two, which is compression. Where σ₂′ = σ₃′ that is σ₁′ − σ₃′ in
/// either plane. The sign does not hang on whether σ₂′ and σ₃′ are equal; along a path it changes
/// where σ₁′ passes p′, at q ≠ 0 unless the state is isotropic there.
template <class Space>
double deviator_stress(const sim::PointState<Space>& state);

extern template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Axisymmetric>&);
extern template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&);
extern template double deviator_stress(const sim::PointState<sim::Axisymmetric>&);
extern template double deviator_stress(const sim::PointState<sim::Tensor>&);

}  // namespace triax::study
