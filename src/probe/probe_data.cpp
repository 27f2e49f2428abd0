// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "src/probe/probe_words.hpp"

namespace triax::src {
namespace {

/// Head of a table: that it is simulated, with what and how.
FigureData titled(const study::ProbeResult& result, const study::Probing& probing,
                  const std::string& title) {
  FigureData data{.title = title + result.material.name,
                  .origin = "simulated",
                  .remarks = {},
                  .columns = {{"state", ""},
                              {"p_eff_kPa", "kPa"},
                              {"q_kPa", "kPa"},
                              {"eta", ""},
                              {"void_ratio", ""}},
                  .rows = {}};
  data.remarks.push_back("law: " + result.material.law->title);
  if (!result.material.material.based_on.empty())
    data.remarks.push_back("based on: " + result.material.material.based_on);
  data.remarks.push_back("probes: " + probing_words(probing));
  data.remarks.push_back("plane: " + plane_words(probing.plane));
  if (!result.path.empty()) data.remarks.push_back("path: " + result.path);
  for (std::size_t i = 0; i < result.states.size(); ++i)
    if (!result.states[i].name.empty())
      data.remarks.push_back(fmt::format("state {}: {}", i + 1, result.states[i].name));
  return data;
}

/// The probing of the circles that are drawn.
study::Probing drawn_probing(const study::ProbeResult& result) {
  study::Probing probing = result.probing;
  probing.directions = result.figures.directions;
  return probing;
}

/// Number of a state of the result, and what it is.
std::vector<std::optional<double>> row_of(const study::ProbeResult& result, std::size_t place) {
  const study::ProbedState& state = result.states[place];
  return {static_cast<double>(place + 1), state.p / 1e3, state.q / 1e3, state.eta(),
          state.void_ratio};
}

FigureData empty_probes_table(const study::ProbeResult& result, const study::Probing& probing) {
  const bool axisymmetric = probing.plane == sim::ProbePlane::axisymmetric;
  const std::string lateral = axisymmetric ? "radial" : "lateral";
  FigureData data = titled(result, probing, "second-order work in every direction, ");
  data.columns.insert(data.columns.end(), {{"alpha_deg", "°"},
                                           {"w2_normalised", ""},
                                           {"w2_Pa", "Pa"},
                                           {"axial_stress_increment_kPa", "kPa"},
                                           {lateral + "_stress_increment_kPa", "kPa"},
                                           {"axial_strain_increment", ""},
                                           {lateral + "_strain_increment", ""}});
  return data;
}

void put_circle(const study::ProbeResult& result, std::size_t place, const sim::Circle& circle,
                FigureData& data) {
  const bool axisymmetric = result.probing.plane == sim::ProbePlane::axisymmetric;
  const double root = axisymmetric ? std::numbers::sqrt2 : 1;
  for (const sim::Probe& probe : circle.probes) {
    auto row = row_of(result, place);
    row.emplace_back(sim::degrees(probe.angle));
    if (probe.answered)
      row.insert(row.end(),
                 {probe.normalised, probe.second_order_work, probe.stress.y() / 1e3,
                  probe.stress.x() / root / 1e3, probe.strain.y(), probe.strain.x() / root});
    row.resize(data.columns.size());
    data.rows.push_back(std::move(row));
  }
}

}  // namespace

FigureData probes_data(const study::ProbeResult& result) {
  FigureData data = empty_probes_table(result, result.probing);
  for (std::size_t place = 0; place < result.states.size(); ++place)
    put_circle(result, place, result.states[place].circle, data);
  return data;
}

FigureData drawn_probes_data(const study::ProbeResult& result,
                             const std::vector<study::DrawnCircle>& circles) {
  FigureData data = empty_probes_table(result, drawn_probing(result));
  for (const auto& drawn : circles) put_circle(result, drawn.state, drawn.circle, data);
  return data;
}

FigureData cones_data(const study::ProbeResult& result) {
  FigureData data = titled(result, result.probing, "cones of unstable directions, ");
  data.columns.insert(data.columns.end(), {{"cone", ""},
                                           {"from_deg", "°"},
                                           {"to_deg", "°"},
                                           {"opening_deg", "°"},
                                           {"strongest_deg", "°"},
                                           {"w2_normalised_least", ""}});
  for (std::size_t place = 0; place < result.states.size(); ++place) {
    const auto& cones = result.states[place].circle.cones;
    for (std::size_t i = 0; i < std::max<std::size_t>(cones.size(), 1); ++i) {
      auto row = row_of(result, place);
      if (i < cones.size()) {
        const sim::Cone& cone = cones[i];
        row.insert(row.end(), {static_cast<double>(i + 1), sim::degrees(cone.from),
                               sim::degrees(cone.to), sim::degrees(cone.opening()),
                               sim::degrees(cone.strongest.angle), cone.strongest.normalised});
      }
      row.resize(data.columns.size());
      data.rows.push_back(std::move(row));
    }
  }
  return data;
}

FigureData drawn_control_data(const study::ProbeResult& result) {
  FigureData data = titled(result, drawn_probing(result), "control of proportional strain paths, ");
  data.columns.insert(data.columns.end(), {{"R", ""},
                                           {"controllable", ""},
                                           {"index", ""},
                                           {"mode_alpha_deg", "°"},
                                           {"mode_w2_normalised", ""}});
  for (const auto& drawn : result.figures.circles)
    for (const auto& at : result.states[drawn.state].control.scan) {
      auto row = row_of(result, drawn.state);
      row.insert(row.end(), {at.R, at.controllable ? 1.0 : 0.0, at.index});
      if (at.mode.answered)
        row.insert(row.end(), {sim::degrees(at.mode.angle), at.mode.normalised});
      row.resize(data.columns.size());
      data.rows.push_back(std::move(row));
    }
  return data;
}

}  // namespace triax::src
