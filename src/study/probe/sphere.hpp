// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes of states in all directions of the principal increments (dσ₁, dσ₂, dσ₃).
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/sphere.hpp"
#include "src/study/probe/state_head.hpp"

namespace triax::study {

struct SphereProbing {
  sim::ProbeKind kind = sim::ProbeKind::stress;
  double norm = 1e3;  ///< of the increments, Pa; of strain probes, strain
  int rings = 18;     ///< of cells from compression to extension of all axes

  double step_deg() const { return 180.0 / rings; }
};

/// An increment of the norm with the law's answer, along axes 1 to 3.
struct SphereIncrement {
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();  ///< Pa
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  double second_order_work = 0;  ///< dσ′·dε, Pa
};

/// Of a direction without an answer what is not imposed means nothing.
SphereIncrement increment_of(const sim::SphereProbe& probe, const SphereProbing& probing);

struct ProbedSphere : StateHead {
  sim::Sphere sphere;    ///< answers to increments of norm 1, by the rate
  sim::FreeProbe least;  ///< over all six components
  /// The law's answer in the direction of a test's own stress increment; of unit norm, by the rate.
  std::optional<sim::SphereProbe> own;
};

/// Throws as head_of does. Pre-condition: the material has a law for the full tensor.
ProbedSphere probe_sphere_of(const lab::MaterialSet& material,
                             const StateToProbe<sim::Tensor>& what, const SphereProbing& probing);

struct SphereResult {
  lab::MaterialSet material;
  SphereProbing probing;
  std::vector<ProbedSphere> states;
  bool many = false;                  ///< several states were asked for, however many there are
  std::string path;                   ///< name of the path along which they lie; empty: none
  std::vector<std::string> warnings;  ///< that are not of one state

  /// Whether any direction of any state has an answer.
  bool any_answer() const;
};

}  // namespace triax::study
