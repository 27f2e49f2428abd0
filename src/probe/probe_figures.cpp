#include "src/probe/probe_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/output/words.hpp"
#include "src/probe/circular_diagram.hpp"
#include "src/probe/cones_figure.hpp"
#include "src/probe/control_scan_figure.hpp"
#include "src/probe/response_envelope.hpp"
#include "src/probe/work_over_angle.hpp"

namespace triax::src {
namespace {

/// Curves that one diagram can hold and still be read.
constexpr std::size_t kMostCurves = 5;

/// States to be drawn: all, or some evenly spread with the first and the last among them.
std::vector<const study::ProbedState*> drawn_states(const ProbeReport& report) {
  std::vector<const study::ProbedState*> answered, drawn;
  for (const study::ProbedState& state : report.states)
    if (state.circle.least.answered) answered.push_back(&state);
  const std::size_t count = answered.size(), shown = std::min(count, kMostCurves);
  for (std::size_t i = 0; i < shown; ++i)
    drawn.push_back(answered[shown == 1 ? 0 : i * (count - 1) / (shown - 1)]);
  return drawn;
}

std::vector<const study::ProbedState*> all_states(const ProbeReport& report) {
  std::vector<const study::ProbedState*> all;
  for (const study::ProbedState& state : report.states) all.push_back(&state);
  return all;
}

bool all_share(const std::vector<const study::ProbedState*>& states,
               double study::StateHead::*value) {
  return std::ranges::all_of(states, [&](const study::ProbedState* s) {
    return std::abs(s->*value - states.front()->*value) <= 1e-9 * std::abs(s->*value);
  });
}

std::string eta_words(const study::ProbedState& state) { return "η = " + number(state.eta(), 3); }

/// What tells a state from the others.
std::string curve_name(const study::ProbedState& state, bool one_p) {
  if (!state.name.empty()) return state.name + ", " + eta_words(state);
  return one_p ? eta_words(state)
               : fmt::format("{}, p′ = {} kPa", eta_words(state), number(state.p / 1e3, 1));
}

Subject subject_of(const ProbeReport& report,
                   const std::vector<const study::ProbedState*>& states) {
  Subject subject{.material = report.material.name,
                  .state = {},
                  .plane = report.probing.plane,
                  .kind = report.probing.kind};
  if (states.empty()) return subject;
  if (all_share(states, &study::StateHead::p))
    subject.state = fmt::format("p′ = {:.4g} kPa", states.front()->p / 1e3);
  if (all_share(states, &study::StateHead::void_ratio))
    subject.state +=
        fmt::format("{}e = {:.4g}", subject.state.empty() ? "" : ", ", states.front()->void_ratio);
  if (states.size() == 1) subject.state += ", " + eta_words(*states.front());
  return subject;
}

/// Head of a table: that it is simulated, with what and how.
FigureData titled(const ProbeReport& report, const std::string& title) {
  FigureData data{.title = title + report.material.name,
                  .origin = "simulated",
                  .remarks = {},
                  .columns = {{"state", ""},
                              {"p_eff_kPa", "kPa"},
                              {"q_kPa", "kPa"},
                              {"eta", ""},
                              {"void_ratio", ""}},
                  .rows = {}};
  data.remarks.push_back("law: " + report.material.law->title);
  if (!report.material.material.based_on.empty())
    data.remarks.push_back("based on: " + report.material.material.based_on);
  data.remarks.push_back("probes: " + probing_words(report.probing));
  data.remarks.push_back("plane: " + plane_words(report.probing.plane));
  if (!report.path.empty()) data.remarks.push_back("path: " + report.path);
  for (std::size_t i = 0; i < report.states.size(); ++i)
    if (!report.states[i].name.empty())
      data.remarks.push_back(fmt::format("state {}: {}", i + 1, report.states[i].name));
  return data;
}

/// The same with finer circles at the states that are drawn, if those probed for the report would
/// look angular.
ProbeReport with_smooth_circles(const ProbeReport& report) {
  constexpr double kCoarse = 2;  // degrees
  constexpr int kDirections = 360;
  ProbeReport fine = report;
  if (report.probing.step_deg() <= kCoarse) return fine;
  fine.probing.directions = kDirections;
  for (const study::ProbedState* state : drawn_states(report))
    if (state->circle_of)
      fine.states[static_cast<std::size_t>(state - report.states.data())].circle =
          state->circle_of(kDirections);
  return fine;
}

/// Number of the state in the report, and what it is.
std::vector<std::optional<double>> row_of(const ProbeReport& report,
                                          const study::ProbedState& state) {
  const auto count = static_cast<double>(&state - report.states.data() + 1);
  return {count, state.p / 1e3, state.q / 1e3, state.eta(), state.void_ratio};
}

/// Every direction of these states.
FigureData probes_data(const ProbeReport& report,
                       const std::vector<const study::ProbedState*>& states) {
  const bool axisymmetric = report.probing.plane == sim::ProbePlane::axisymmetric;
  const double root = axisymmetric ? std::numbers::sqrt2 : 1;
  const std::string lateral = axisymmetric ? "radial" : "lateral";
  FigureData data = titled(report, "second-order work in every direction, ");
  data.columns.insert(data.columns.end(), {{"alpha_deg", "°"},
                                           {"w2_normalised", ""},
                                           {"w2_Pa", "Pa"},
                                           {"axial_stress_increment_kPa", "kPa"},
                                           {lateral + "_stress_increment_kPa", "kPa"},
                                           {"axial_strain_increment", ""},
                                           {lateral + "_strain_increment", ""}});
  for (const study::ProbedState* state : states)
    for (const sim::Probe& probe : state->circle.probes) {
      auto row = row_of(report, *state);
      row.emplace_back(sim::degrees(probe.angle));
      if (probe.answered)
        row.insert(row.end(),
                   {probe.normalised, probe.second_order_work, probe.stress.y() / 1e3,
                    probe.stress.x() / root / 1e3, probe.strain.y(), probe.strain.x() / root});
      row.resize(data.columns.size());
      data.rows.push_back(std::move(row));
    }
  return data;
}

/// Every R of these states.
FigureData control_data(const ProbeReport& report,
                        const std::vector<const study::ProbedState*>& states) {
  FigureData data = titled(report, "control of proportional strain paths, ");
  data.columns.insert(data.columns.end(), {{"R", ""},
                                           {"controllable", ""},
                                           {"index", ""},
                                           {"mode_alpha_deg", "°"},
                                           {"mode_w2_normalised", ""}});
  for (const study::ProbedState* state : states)
    for (const auto& at : state->control.scan) {
      auto row = row_of(report, *state);
      row.insert(row.end(), {at.R, at.controllable ? 1.0 : 0.0, at.index});
      if (at.mode.answered)
        row.insert(row.end(), {sim::degrees(at.mode.angle), at.mode.normalised});
      row.resize(data.columns.size());
      data.rows.push_back(std::move(row));
    }
  return data;
}

/// Whether two states would be drawn over each other: within 1/40 of the largest stress.
bool close_together(const TriaxialState& a, const TriaxialState& b, double largest) {
  return std::hypot(a.p - b.p, a.q - b.q) < largest / 40;
}

ConesPicture picture_of(const ProbeReport& report, const Subject& subject) {
  ConesPicture picture{
      .subject = subject, .states = {}, .paths = {}, .limit_stress_ratio = {}, .tests = {}};
  if (const auto* law = report.material.material.axisymmetric.get())
    picture.limit_stress_ratio = law->limit_stress_ratio();
  double largest = 0;
  for (const study::ProbedState& state : report.states)
    largest = std::max({largest, state.p, std::abs(state.q)});
  std::vector<TriaxialState> path;
  for (const study::ProbedState& state : report.states) {
    const TriaxialState at{state.p, state.q};
    if (picture.states.empty() || !close_together(at, picture.states.back().state, largest))
      picture.states.push_back({at, sectors_of(state.circle)});
    if (state.from_path) path.push_back(at);
    if (state.own)
      picture.tests.push_back(
          {state.test->name, at, state.own->angle, state.test->origin == lab::Origin::simulated});
  }
  if (path.size() > 1) picture.paths.push_back(std::move(path));
  return picture;
}

}  // namespace

FigureData probes_data(const ProbeReport& report) {
  return probes_data(report, all_states(report));
}

FigureData cones_data(const ProbeReport& report) {
  FigureData data = titled(report, "cones of unstable directions, ");
  data.columns.insert(data.columns.end(), {{"cone", ""},
                                           {"from_deg", "°"},
                                           {"to_deg", "°"},
                                           {"opening_deg", "°"},
                                           {"strongest_deg", "°"},
                                           {"w2_normalised_least", ""}});
  for (const study::ProbedState& state : report.states) {
    const auto& cones = state.circle.cones;
    for (std::size_t i = 0; i < std::max<std::size_t>(cones.size(), 1); ++i) {
      auto row = row_of(report, state);
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

namespace {

/// Ranges of R in which one of the senses is lost, rising and apart.
std::vector<sim::LostControl> lost_in_a_sense(const study::ControlReport& control) {
  auto ranges = control.lost;
  std::ranges::sort(ranges, {}, &sim::LostControl::from);
  std::vector<sim::LostControl> apart;
  for (const auto& range : ranges) {
    if (apart.empty() || range.from > apart.back().to) {
      apart.push_back(range);
    } else if (range.to > apart.back().to) {
      apart.back().to = range.to;
      apart.back().ends = range.ends;
    }
  }
  return apart;
}

}  // namespace

std::vector<NamedFigure> probe_figures(const ProbeReport& report) {
  const ProbeReport fine = with_smooth_circles(report);
  const auto drawn = drawn_states(fine);
  if (drawn.empty()) return {};
  const Subject subject = subject_of(fine, drawn);
  const bool one_p = all_share(drawn, &study::StateHead::p);
  std::vector<NamedCircle> circles;
  for (const study::ProbedState* state : drawn)
    circles.push_back({curve_name(*state, one_p), state->circle});
  std::vector<NamedFigure> figures;
  const auto add = [&](const char* name, Drawing drawing, const FigureData& data) {
    if (drawing.plot) figures.push_back({name, std::move(drawing), data});
  };
  const FigureData probes = probes_data(fine, drawn);
  add("circular", circular_diagram(circles, subject), probes);
  add("polar", polar_diagram(circles, subject), probes);
  add("work", work_over_angle(circles, subject), probes);
  const study::ProbedState& last = *drawn.back();
  add("envelope", response_envelope(last.circle, report.probing.norm, subject_of(fine, {&last})),
      probes_data(fine, {&last}));
  std::vector<NamedScan> scans;
  for (const study::ProbedState* state : drawn)
    scans.push_back(
        {curve_name(*state, one_p), state->control.scan, lost_in_a_sense(state->control)});
  add("control", control_scan_figure(scans, subject), control_data(fine, drawn));
  if (report.probing.plane == sim::ProbePlane::axisymmetric &&
      report.probing.kind == sim::ProbeKind::stress) {
    const ConesPicture picture = picture_of(report, subject_of(report, all_states(report)));
    const FigureData cones = cones_data(report);
    add("cones_pq", cones_figure(picture, StressAxes::p_q), cones);
    add("cones_rendulic", cones_figure(picture, StressAxes::rendulic), cones);
  }
  return figures;
}

}  // namespace triax::src
