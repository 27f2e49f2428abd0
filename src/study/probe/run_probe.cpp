// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/probe/run_probe.hpp"

#include "src/study/probe/figure_values.hpp"

namespace triax::study {
namespace {

constexpr const char* kWhat = "probes";

double share(std::size_t done, std::size_t all) {
  return static_cast<double>(done) / static_cast<double>(all);
}

template <class Space>
ProbeResult run_in(const ProbeRequest& request, const Progress& progress) {
  auto wanted = states_to_probe<Space>(request.material, request.states, progress);
  ProbeResult result{.material = request.material,
                     .probing = request.probing,
                     .states = {},
                     .many = wanted.many,
                     .path = std::move(wanted.path),
                     .warnings = std::move(wanted.warnings),
                     .isolated = {},
                     .figures = {}};
  for (const auto& state : wanted.states) {
    result.states.push_back(probe_state(result.material, state, result.probing));
    if (!result.isolated && !state.passed.empty())
      result.isolated = first_unstable(result.material, state.passed, result.probing);
    show(progress, kWhat, share(result.states.size(), wanted.states.size()));
  }
  if (request.figures) result.figures = figure_values(result, wanted.states);
  return result;
}

}  // namespace

ProbeResult run_probe(const ProbeRequest& request, const Progress& progress) {
  return request.probing.plane == sim::ProbePlane::plane_strain
             ? run_in<sim::Tensor>(request, progress)
             : run_in<sim::Axisymmetric>(request, progress);
}

SphereResult run_sphere(const SphereRequest& request, const Progress& progress) {
  auto wanted = states_to_probe<sim::Tensor>(request.material, request.states, progress);
  SphereResult result{.material = request.material,
                      .probing = request.probing,
                      .states = {},
                      .many = wanted.many,
                      .path = std::move(wanted.path),
                      .warnings = std::move(wanted.warnings)};
  for (const auto& state : wanted.states) {
    result.states.push_back(probe_sphere_of(result.material, state, result.probing));
    show(progress, kWhat, share(result.states.size(), wanted.states.size()));
  }
  return result;
}

}  // namespace triax::study
