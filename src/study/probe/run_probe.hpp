// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Probes of states of a law in a plane, or in all directions of the principal increments.
#include "src/study/probe/probe_result.hpp"
#include "src/study/probe/sphere.hpp"
#include "src/study/probe/states_to_probe.hpp"

namespace triax::study {

struct ProbeRequest {
  lab::MaterialSet material;
  StatesWanted states;
  Probing probing;
  bool figures = false;  ///< whether ProbeResult::figures is wanted, which takes further probes
};

/// Throws lab::BadInput where a state cannot be had or the law refuses it.
ProbeResult run_probe(const ProbeRequest& request, const Progress& progress = {});

struct SphereRequest {
  lab::MaterialSet material;
  StatesWanted states;
  SphereProbing probing;
};

/// Throws as run_probe does, and where the material has no law for the full tensor.
SphereResult run_sphere(const SphereRequest& request, const Progress& progress = {});

}  // namespace triax::study
