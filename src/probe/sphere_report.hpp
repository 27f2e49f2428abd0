#pragma once
// Probes of states in all directions of the principal increments (dσ₁, dσ₂, dσ₃), as text and JSON.
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/sphere.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/figure_files.hpp"
#include "src/study/probe/probed_state.hpp"

namespace triax::src {

struct SphereProbing {
  sim::ProbeKind kind = sim::ProbeKind::stress;
  double norm = 1e3;  ///< of the increments, Pa; of strain probes, strain
  int rings = 18;     ///< of cells from compression to extension of all axes
};

struct ProbedSphere : study::StateHead {
  sim::Sphere sphere;    ///< answers to increments of norm 1, by the rate
  sim::FreeProbe least;  ///< over all six components
  /// The law's answer in the direction of a test's own stress increment; of unit norm, by the rate.
  std::optional<sim::SphereProbe> own;
};

ProbedSphere probe_sphere_of(const lab::MaterialSet& material,
                             const study::StateToProbe<sim::Tensor>& what,
                             const SphereProbing& probing);

struct SphereReport {
  lab::MaterialSet material;
  SphereProbing probing;
  std::vector<ProbedSphere> states;
  bool many = false;
  std::string path;
  std::vector<std::string> warnings;
};

/// As probe_json: a single state is part of the document, several are its list "states".
std::string sphere_json(const SphereReport& report);
std::string sphere_text(const SphereReport& report);
FigureData sphere_data(const SphereReport& report);
/// Of the last state.
Drawing sphere_drawing(const SphereReport& report);

}  // namespace triax::src
