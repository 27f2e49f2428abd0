// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One state of a law probed in every direction of a plane.
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/octolinear_cones.hpp"
#include "src/study/probe/cone_place.hpp"
#include "src/study/probe/first_unstable.hpp"
#include "src/study/probe/state_head.hpp"

namespace triax::study {

/// Answers are those of increments of the norm.
struct ProbedState : StateHead {
  sim::Circle circle;
  Controllability control;         ///< by the rate, whatever the probes are
  sim::Probe isotropic_unloading;  ///< a stress probe, whatever the others are
  /// The law's answer to a stress increment in the direction of the test's own; axisymmetric only.
  std::optional<sim::Probe> own;
  /// Where that direction lies among the cones; empty without a cone, or under strain probes.
  std::optional<ConePlace> own_place;
  /// Of an octolinear law under stress probes: its cones in closed form.
  std::optional<std::vector<sim::UnstableSector>> closed_form;
  std::string refusal;  ///< the law's words on the first direction that it refuses; empty: none

  FirstUnstable as_first() const;
};

/// Throws as head_of does. Pre-condition: the space is that of the plane.
template <class Space>
ProbedState probe_state(const lab::MaterialSet& material, const StateToProbe<Space>& what,
                        const Probing& probing);

/// Its circle alone. Pre-condition: the law does not refuse the state.
template <class Space>
sim::Circle probed_circle(const lab::MaterialSet& material, const StateToProbe<Space>& what,
                          const Probing& probing);

extern template ProbedState probe_state(const lab::MaterialSet&,
                                        const StateToProbe<sim::Axisymmetric>&, const Probing&);
extern template ProbedState probe_state(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&,
                                        const Probing&);
extern template sim::Circle probed_circle(const lab::MaterialSet&,
                                          const StateToProbe<sim::Axisymmetric>&, const Probing&);
extern template sim::Circle probed_circle(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&,
                                          const Probing&);

}  // namespace triax::study
