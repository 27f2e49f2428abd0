// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_axes.hpp"

#include <algorithm>
#include <cmath>

#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {

SheetAxis axial_strain_axis() {
  return {"ε₁ (%)", [](const lab::State& s) { return s.strain.axial * 100; }};
}
SheetAxis q_axis() {
  return {"q (kPa)", [](const lab::State& s) { return s.q * 1e-3; }};
}
SheetAxis p_axis() {
  return {"p′ (kPa)", [](const lab::State& s) { return s.p_eff * 1e-3; }};
}
SheetAxis u_axis() {
  return {"u (kPa)", [](const lab::State& s) { return s.pore_pressure * 1e-3; }};
}
SheetAxis volumetric_strain_axis() {
  return {"ε_v (%)", [](const lab::State& s) { return s.volumetric_strain * 100; }};
}
SheetAxis eta_axis() {
  // Of stresses that are gone there is no ratio.
  return {"η = q/p′", [](const lab::State& s) {
            constexpr double kGone = 5e3;  // Pa
            return s.p_eff > kGone ? s.eta() : lab::kMissing;
          }};
}
SheetAxis void_ratio_axis() {
  return {"e", [](const lab::State& s) { return s.void_ratio; }};
}

namespace {

/// One point, or none.
Points point_in(const lab::State& state, const SheetAxis& x, const SheetAxis& y) {
  const QPointF point(x.value(state), y.value(state));
  if (!std::isfinite(point.x()) || !std::isfinite(point.y())) return {};
  return {point};
}

}  // namespace

std::vector<lab::State> believed(const SheetTest& test, bool shear) {
  const auto last = study::last_believed_reading(test.result.stored);
  std::vector<lab::State> states;
  for (const auto& s : test.result.curves.states)
    if ((!last || s.reading <= *last) &&
        study::is_shear(test.result.stored.header, s.stage) == shear)
      states.push_back(s);
  return states;
}

Points failure_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y) {
  return test.values.failure ? point_in(test.values.failure->state, x, y) : Points{};
}

Points onset_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y) {
  const auto onset = study::collapse_onset(test.result.stored);
  if (!onset || !test.result.stored.state_at_onset) return {};
  return point_in(*test.result.stored.state_at_onset, x, y);
}

Points loss_of_control_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y) {
  const auto state = study::nearest_state(test.result.curves.states,
                                          test.result.stored.summary.collapse.loss_of_control);
  return state ? point_in(*state, x, y) : Points{};
}

JoinedLine line_in(const SheetTest& test, const std::vector<lab::State>& states, const SheetAxis& x,
                   const SheetAxis& y) {
  return joined_line(states, test.result.curves.breaks, [&](const lab::State& state) {
    return QPointF(x.value(state), y.value(state));
  });
}

Points consolidation_points(const SheetTest& test) {
  const auto& curve = test.values.consolidation;
  if (!curve || curve->points.size() < 3) return {};
  Points points;
  for (const auto& p : curve->points)
    points.emplace_back(std::sqrt(p.time_s / 60), p.outflow * (curve->in_m3 ? 1e6 : 100));
  return points;
}

JoinedLine loaded(const JoinedLine& line) {
  JoinedLine out;
  auto join = study::Join::solid;  // to the last point that was kept
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    join = std::max(join, line.joins[i]);
    if (line.points[i].x() <= 1) continue;
    out.add(line.points[i], join);
    join = study::Join::solid;
  }
  return out;
}

}  // namespace triax::src
