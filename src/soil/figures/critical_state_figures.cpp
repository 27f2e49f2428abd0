// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/figures/critical_state_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/soil/figures/trend_figure.hpp"

namespace triax::src {
namespace {

constexpr int kCriticalWidth = 700, kCriticalHeight = 520 + kNoteHeight;
const QColor kPath(0x9A, 0x9A, 0x9A);

using study::CriticalKind;

/// Where tests are in the plane at their critical state; empty where that is not known.
template <class Place>
Points critical_points(const study::Soil& soil, CriticalKind kind, const Place& place) {
  Points points;
  for (const auto& t : soil.tests)
    if (t.used && !t.cyclic && t.critical.kind == kind)
      if (const std::optional<QPointF> at = place(t)) points.push_back(*at);
  return points;
}

std::optional<QPointF> in_e_plane(const study::TestPoints& t) {
  if (!t.critical.void_ratio) return std::nullopt;
  return QPointF(std::exp(t.critical.log_p.value), t.critical.void_ratio->value);
}

double side(const study::TestPoints& t) { return t.extension ? -1 : 1; }

std::optional<QPointF> in_q_plane(const study::TestPoints& t) {
  const double p = std::exp(t.critical.log_p.value);
  return QPointF(p, side(t) * p * t.critical.eta.value);
}

template <class Place>
void draw_states(QCPAxisRect& rect, const study::Soil& soil, const Place& place) {
  const auto marker = [](const QBrush& brush) {
    return QCPScatterStyle(QCPScatterStyle::ssCircle, line(kInk, 1.3), brush, 8);
  };
  if (const auto points = critical_points(soil, CriticalKind::reached, place); !points.empty())
    draw_markers(rect, points, marker(QBrush(kBlue)), "critical state, reached");
  if (const auto points = critical_points(soil, CriticalKind::extrapolated, place); !points.empty())
    draw_markers(rect, points, marker(QBrush(Qt::white)), "critical state, extrapolated");
}

template <class Place>
void draw_paths(QCPAxisRect& rect, const study::Soil& soil, const Place& place) {
  bool named = false;
  for (const auto& t : soil.tests) {
    if (!t.used || t.cyclic) continue;
    Points path;
    for (const auto& p : t.path)
      if (const std::optional<QPointF> at = place(t, p)) path.push_back(*at);
    if (path.size() < 2) continue;
    draw_curve(rect, path, line(kPath, 1.0), named ? "" : "paths of the tests");
    named = true;
  }
}

FigureData states_data(const study::Soil& soil, const std::string& title) {
  FigureData data{.title = title,
                  .origin = std::ranges::all_of(soil.tests, &study::TestPoints::simulated)
                                ? "simulated"
                                : "recorded",
                  .remarks = {"extrapolated: 1, reached: 0"},
                  .columns = {{"test_id", ""},
                              {"p_eff_kPa", "kPa"},
                              {"q_kPa", "kPa"},
                              {"void_ratio", ""},
                              {"extrapolated", ""}},
                  .rows = {}};
  for (const auto& t : soil.tests) {
    const auto& c = t.critical;
    if (!t.used || t.cyclic || c.kind == CriticalKind::none) continue;
    const double p = std::exp(c.log_p.value);
    data.rows.push_back({static_cast<double>(t.id), p, side(t) * p * c.eta.value,
                         c.void_ratio ? std::optional(c.void_ratio->value) : std::nullopt,
                         c.kind == CriticalKind::extrapolated ? 1.0 : 0.0});
  }
  return data;
}

void add_lines(QCPAxisRect& rect, const study::Soil& soil, double from, double to) {
  Points log_line, power, band_low, band_high;
  for (int i = 0; i <= 80; ++i) {
    const double p = from * std::pow(to / from, i / 80.0);
    const auto at = soil.critical_line->line.line_at(std::log(p));
    log_line.emplace_back(p, at.value);
    band_low.emplace_back(p, at.low);
    band_high.emplace_back(p, at.high);
    power.emplace_back(p, soil.critical_power->at(p));
  }
  Points band = band_low;
  band.insert(band.end(), band_high.rbegin(), band_high.rend());
  lay_behind(*draw_area(rect, band, QColor(0xD6, 0xE6, 0xF2), QPen(Qt::NoPen),
                        "95 % interval of the line"));
  const auto& fit = soil.critical_line->line;
  draw_curve(rect, log_line, line(kBlue, 2),
             fmt::format("e = {:.3f} − {:.4f} ln(p′/1 kPa)", fit.a, -fit.b));
  const auto& of = *soil.critical_power;
  draw_curve(rect, power, line(kVermilion, 1.8, Qt::DashLine),
             fmt::format("e = {:.3f} − {:.4f} (p′/100 kPa)^{:.2f}", of.void_ratio.value,
                         of.slope.value, of.exponent.value));
}

}  // namespace

NamedFigure critical_line_figure(const study::Soil& soil) {
  auto plot = make_plot(kCriticalWidth, kCriticalHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, "mean effective stress p′ (kPa)", "void ratio e");
  make_logarithmic(*plot->xAxis);
  RangeOf p_range, e_range;
  for (const auto& t : soil.tests) {
    if (!t.used || t.cyclic || !t.void_ratio) continue;
    e_range.add(*t.void_ratio);
    if (t.p_eff_kPa) p_range.add(std::log10(*t.p_eff_kPa));
    if (t.end) p_range.add(std::log10(std::max(t.end->p_eff_kPa, 1.0)));
    if (const auto at = in_e_plane(t); at && t.critical.kind != CriticalKind::none)
      p_range.add(std::log10(std::max(at->x(), 1.0))), e_range.add(at->y());
  }
  const QCPRange p = p_range.with_margin(0.06, false);
  plot->xAxis->setRange(std::pow(10, p.lower), std::pow(10, p.upper));
  plot->yAxis->setRange(e_range.with_margin(0.10, false));
  add_lines(rect, soil, std::pow(10, p.lower), std::pow(10, p.upper));
  draw_paths(rect, soil, [](const auto&, const auto& at) -> std::optional<QPointF> {
    return at.void_ratio ? std::optional(QPointF(at.p_eff_kPa, *at.void_ratio)) : std::nullopt;
  });
  draw_states(rect, soil, in_e_plane);
  Points odd;
  for (const auto& q : soil.critical_line->odd_points) odd.emplace_back(std::exp(q.x), q.y);
  if (!odd.empty())
    draw_markers(rect, odd,
                 QCPScatterStyle(QCPScatterStyle::ssCross, line(kVermilion, 2), QBrush(), 11),
                 "not used: does not fit the others");
  legend_below(*plot, 2);
  note_below(*plot, soil_note(soil));
  const std::string caption = fmt::format(
      "Critical state line of {} tests, with its 95 % interval.", soil.critical_line->line.tests);
  return {"critical_state_line", {std::move(plot), caption}, states_data(soil, caption)};
}

NamedFigure critical_ratio_figure(const study::Soil& soil) {
  auto plot = make_plot(kCriticalWidth, kCriticalHeight);
  auto& rect = *plot->axisRect();
  style_axes(rect, "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
  RangeOf p_range, q_range;
  p_range.add(0), q_range.add(0);
  for (const auto& t : soil.tests) {
    if (!t.used || t.cyclic) continue;
    for (const auto& p : t.path) p_range.add(p.p_eff_kPa), q_range.add(side(t) * p.q_kPa);
    if (t.critical.kind == CriticalKind::none) continue;
    const QPointF at = *in_q_plane(t);
    p_range.add(at.x()), q_range.add(at.y());
  }
  plot->xAxis->setRange(p_range.with_margin(0.05, true));
  plot->yAxis->setRange(q_range.with_margin(0.06, true));
  const double far = plot->xAxis->range().upper;
  draw_paths(rect, soil, [](const auto& t, const auto& at) -> std::optional<QPointF> {
    return QPointF(at.p_eff_kPa, side(t) * at.q_kPa);
  });
  std::string caption = "Stress paths";
  const auto add = [&](const std::optional<study::Level>& level, double sign, const char* name) {
    if (!level) return;
    const auto& m = level->fit.mean;
    draw_area(rect, {{0, 0}, {far, sign * far * m.low}, {far, sign * far * m.high}},
              QColor(0xD6, 0xE6, 0xF2), QPen(Qt::NoPen));
    const std::string words =
        fmt::format("{} = {:.3f} ({:.3f} to {:.3f})", name, m.value, m.low, m.high);
    draw_curve(rect, {{0, 0}, {far, sign * far * m.value}}, line(kBlue, 1.8), words);
    caption += fmt::format(", {} of {} tests", words, m.tests);
  };
  add(soil.critical_ratio, 1, "M");
  add(soil.extension_ratio, -1, "M_e");
  draw_states(rect, soil, in_q_plane);
  legend_below(*plot, 2);
  note_below(*plot, soil_note(soil));
  caption += ".";
  return {"critical_stress_ratio", {std::move(plot), caption}, states_data(soil, caption)};
}

}  // namespace triax::src
