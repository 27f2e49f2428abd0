// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/sphere_figures.hpp"

#include <fmt/format.h>

#include "src/probe/figures/sphere_figure.hpp"
#include "src/probe/sphere_text.hpp"

namespace triax::src {

FigureData sphere_data(const study::SphereResult& result) {
  const bool stress = result.probing.kind == sim::ProbeKind::stress;
  FigureData data{.title = "second-order work in every direction of space, " + result.material.name,
                  .origin = "simulated",
                  .remarks = {"law: " + result.material.law->title,
                              "probes: " + sphere_probing_words(result.probing)},
                  .columns = {{"state", ""},
                              {"p_eff_kPa", "kPa"},
                              {"q_kPa", "kPa"},
                              {"void_ratio", ""},
                              {"polar_deg", "°"},
                              {"azimuth_deg", "°"},
                              {"w2_normalised", ""}},
                  .rows = {}};
  for (const char* axis : {"1", "2", "3"})
    data.columns.push_back(
        {fmt::format("imposed_{}{}", axis, stress ? "_kPa" : ""), stress ? "kPa" : ""});
  for (const char* axis : {"1", "2", "3"})
    data.columns.push_back(
        {fmt::format("response_{}{}", axis, stress ? "" : "_kPa"), stress ? "" : "kPa"});
  const double imposed_unit = stress ? 1e3 : 1, response_unit = stress ? 1 : 1e3;
  for (std::size_t i = 0; i < result.states.size(); ++i) {
    const study::ProbedSphere& state = result.states[i];
    for (const auto& probe : state.sphere.probes) {
      std::vector<std::optional<double>> row = {static_cast<double>(i + 1),
                                                state.p / 1e3,
                                                state.q / 1e3,
                                                state.void_ratio,
                                                sim::degrees(probe.polar),
                                                sim::degrees(probe.azimuth),
                                                std::nullopt};
      if (probe.answered) row.back() = probe.normalised;
      for (int k = 0; k < 3; ++k)
        row.emplace_back(result.probing.norm * probe.direction(k) / imposed_unit);
      for (int k = 0; k < 3 && probe.answered; ++k)
        row.emplace_back(result.probing.norm * probe.response(k) / response_unit);
      row.resize(data.columns.size());
      data.rows.push_back(std::move(row));
    }
  }
  return data;
}

Drawing sphere_drawing(const study::SphereResult& result) {
  if (result.states.empty()) return {};
  const study::ProbedSphere& state = result.states.back();
  std::vector<SphereDirection> directions;
  for (const auto& probe : state.sphere.probes)
    directions.push_back({probe.direction, probe.response, probe.answered, probe.normalised});
  return sphere_figure(directions,
                       {.material = result.material.name,
                        .state = fmt::format("p′ = {:.4g} kPa, q = {:.4g} kPa, e = {:.4g}",
                                             state.p / 1e3, state.q / 1e3, state.void_ratio),
                        .plane = sim::ProbePlane::axisymmetric,
                        .kind = result.probing.kind});
}

}  // namespace triax::src
