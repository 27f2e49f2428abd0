// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/calibrate/implied_domain_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/calibrate/implied_domain_text.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/probe/figures/cones_figure.hpp"

namespace triax::src {
namespace {

using study::Implied;
using study::ImpliedBoundary;
using study::ImpliedCone;

constexpr int kImpliedWidth = 760, kImpliedHeight = 700, kLeastImpliedHeight = 420;
const QColor kBand(0xB9, 0xD8, 0xEC), kPath(0xB4, 0xB4, 0xB4);
const QColor kSure(0xE8, 0x8A, 0x55), kScatter(0xFA, 0xDD, 0xC8);

class Picture {
 public:
  explicit Picture(const study::Calibration& c)
      : c_(c), domain_(*c.domain), plot_(make_plot(kImpliedWidth, kImpliedHeight)) {}

  Drawing draw() {
    style_axes(rect(), "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
    name_legend();
    legend_below(*plot_, 2);
    note_below(*plot_, note());
    find_ranges();
    for (const auto* side : {&domain_.compression, &domain_.extension}) {
      draw_band(*side, &ImpliedBoundary::limit, kGridLine);
      draw_band(*side, &ImpliedBoundary::first_unstable, kBand);
    }
    for (const auto& path : c_.measured) draw_curve(rect(), points_of(path), path_pen());
    for (const auto* side : {&domain_.compression, &domain_.extension}) {
      draw_line(*side, &ImpliedBoundary::limit, limit_pen());
      draw_line(*side, &ImpliedBoundary::first_unstable, boundary_pen());
    }
    for (const ImpliedCone& cone : domain_.cones) draw_cone(cone);
    for (const auto& path : c_.measured)
      if (const auto onset = onset_knot(path))
        draw_markers(rect(), {{onset->p_eff / 1e3, onset->q / 1e3}}, onset_marker());
    return {std::move(plot_), caption()};
  }

 private:
  QCPAxisRect& rect() { return *plot_->axisRect(); }
  static QPen path_pen() { return line(kPath, 1.2); }
  static QPen boundary_pen() { return line(kBlue, 2.2); }
  static QPen limit_pen() { return line(kInk, 1.4); }
  static QPen edge_pen() { return line(kVermilion, 1); }
  static QCPScatterStyle onset_marker() {
    return {QCPScatterStyle::ssCircle, line(kInk, 1.4), QBrush(Qt::white), 7};
  }

  bool has_limit() const {
    return std::ranges::any_of(domain_.compression,
                               [](const auto& at) { return at.limit.best.has_value(); });
  }

  // Entries only: what is drawn comes after the ranges, which depend on the legend's height.
  void name_legend() {
    draw_curve(rect(), {}, boundary_pen(), "first unstable direction, best set");
    draw_area(rect(), {}, kBand, Qt::NoPen, percent() + " of the sets drawn");
    if (has_limit()) draw_curve(rect(), {}, limit_pen(), "plastic limit (its band grey)");
    if (!domain_.cones.empty()) {
      draw_area(rect(), {}, kSure, edge_pen(), "W₂ < 0; lines: edges of the best set");
      draw_area(rect(), {}, kScatter, Qt::NoPen, "edges of " + percent() + " of the sets");
    }
    draw_curve(rect(), {}, path_pen(), "measured stress path");
    RangeOf void_ratios;
    for (const auto& path : c_.measured)
      if (path.onset_eta) void_ratios.add(path.void_ratio);
    if (void_ratios.empty()) return;
    const auto e = void_ratios.with_margin(0, false);
    draw_markers(rect(), {}, onset_marker(),
                 fmt::format("its onset of collapse (e {:.3g} to {:.3g})", e.lower, e.upper));
  }

  std::string percent() const { return fmt::format("{:.0f} %", 100 * domain_.confidence); }
  std::string note() const {
    return fmt::format("simulated: {}, calibrated{}, {} sets, {}", c_.material.law->name,
                       c_.interrupted ? " (interrupted)" : "", domain_.draws,
                       void_ratio_in_words(domain_));
  }
  std::string caption() const {
    return fmt::format(
        "Bifurcation domain and cones of unstable stress directions that {}, calibrated, implies "
        "at {}; bands and light wedges hold {} of {} sets drawn from the estimate.",
        c_.material.law->name, void_ratio_in_words(domain_), percent(), domain_.draws);
  }

  static Points points_of(const study::MeasuredPath& path) {
    Points points = {{path.start.p_eff / 1e3, path.start.q / 1e3}};
    for (const auto& knot : path.knots) points.emplace_back(knot.p_eff / 1e3, knot.q / 1e3);
    return points;
  }

  void find_ranges() {
    RangeOf x, y;
    x.add(0), y.add(0);
    const auto add = [&](const QPointF& at) { x.add(at.x()), y.add(at.y()); };
    for (const auto& path : c_.measured) std::ranges::for_each(points_of(path), add);
    for (const auto* side : {&domain_.compression, &domain_.extension})
      for (const ImpliedBoundary& at : *side)
        add({at.p / 1e3, at.p / 1e3 * at.first_unstable.best.value_or(0)});
    for (const ImpliedCone& cone : domain_.cones) add({cone.p / 1e3, cone.q / 1e3});
    const auto across = x.with_margin(0.08, true), up = y.with_margin(0.08, true);
    plot_->replot();
    const int below = kImpliedHeight - rect().height();
    const int high = static_cast<int>(rect().width() * up.size() / across.size());
    resize_plot(*plot_, kImpliedWidth,
                std::clamp(high + below, kLeastImpliedHeight, kImpliedHeight));
    set_equal_ranges(rect(), across, up);
    if (across.lower >= 0) plot_->xAxis->setRange(0, plot_->xAxis->range().size());
    if (up.lower >= 0) plot_->yAxis->setRange(0, plot_->yAxis->range().size());
    plot_->replot();
  }

  void draw_band(const std::vector<ImpliedBoundary>& side, Implied ImpliedBoundary::*of,
                 const QColor& fill) {
    Points there, back;
    for (const ImpliedBoundary& at : side) {
      const Implied& eta = at.*of;
      if (!eta.low) continue;
      there.emplace_back(at.p / 1e3, *eta.low * at.p / 1e3);
      back.emplace_back(at.p / 1e3, *eta.high * at.p / 1e3);
    }
    there.insert(there.end(), back.rbegin(), back.rend());
    if (there.size() > 2) draw_area(rect(), there, fill, Qt::NoPen);
  }

  void draw_line(const std::vector<ImpliedBoundary>& side, Implied ImpliedBoundary::*of,
                 const QPen& pen) {
    Points points;
    for (const ImpliedBoundary& at : side)
      if (const auto& eta = (at.*of).best) points.emplace_back(at.p / 1e3, *eta * at.p / 1e3);
    draw_curve(rect(), points, pen);
  }

  /// Small where the next state would be covered, kPa.
  double radius_at(const ImpliedCone& cone) const {
    double radius = std::min(0.11 * plot_->xAxis->range().size(), 1.2e-3 * cone.p);
    for (const ImpliedCone& other : domain_.cones)
      if (const double way = std::hypot(other.p - cone.p, other.q - cone.q) / 1e3; way > 0)
        radius = std::min(radius, 1.5 * way);
    return radius;
  }

  Points wedge(const ImpliedCone& cone, double from, double to) const {
    const QPointF tip(cone.p / 1e3, cone.q / 1e3);
    const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / sim::radians(2))));
    const double radius = radius_at(cone);
    Points points = {tip};
    for (int i = 0; i <= steps; ++i)
      points.push_back(tip + radius * increment(std::lerp(from, to, static_cast<double>(i) / steps),
                                                StressAxes::p_q));
    return points;
  }

  void draw_cone(const ImpliedCone& cone) {
    const double from = *cone.from.best, to = *cone.to.best;
    const double widest_from = std::min(from, cone.from.low.value_or(from));
    const double widest_to = std::max(to, cone.to.high.value_or(to));
    const double sure_from = std::max(from, cone.from.high.value_or(from));
    const double sure_to = std::min(to, cone.to.low.value_or(to));
    draw_area(rect(), wedge(cone, widest_from, widest_to), kScatter, Qt::NoPen);
    if (sure_from < sure_to) draw_area(rect(), wedge(cone, sure_from, sure_to), kSure, Qt::NoPen);
    for (const double edge : {from, to}) {
      const Points rim = wedge(cone, edge, edge);
      draw_curve(rect(), {rim.front(), rim.back()}, edge_pen());
    }
    draw_markers(rect(), {{cone.p / 1e3, cone.q / 1e3}},
                 {QCPScatterStyle::ssDisc, line(kVermilion, 1), QBrush(kVermilion), 3});
  }

  const study::Calibration& c_;
  const study::ImpliedDomain& domain_;
  OwnPlot plot_;
};

void add_value(std::vector<std::optional<double>>& row, const Implied& of, double unit) {
  const auto in_unit = [&](const std::optional<double>& value) {
    return value ? std::optional(*value / unit) : std::nullopt;
  };
  row.insert(row.end(), {in_unit(of.best), in_unit(of.low), in_unit(of.high), of.share});
}

void add_columns(std::vector<DataColumn>& columns, const std::string& name,
                 const std::string& unit) {
  const std::string end = unit.empty() ? "" : "_deg";
  for (const char* part : {"", "_low", "_high"})
    columns.push_back({fmt::format("{}{}{}", name, part, end), unit});
  columns.push_back({name + "_share", ""});
}

/// A row a column of the domain, of compression and then of extension; then a row a cone.
FigureData data_of(const study::Calibration& c) {
  const study::ImpliedDomain& d = *c.domain;
  FigureData data{
      .title = "domain and cones that the calibrated set implies",
      .origin = "simulated",
      .remarks = {"law: " + c.material.law->name, void_ratio_in_words(d),
                  fmt::format("low, high: the middle {:.0f} % of {} sets drawn from the estimate; "
                              "fraction: of those that have it",
                              100 * d.confidence, d.draws),
                  "rows without q: criteria at one p', eta below 0 in extension; others: cones"},
      .columns = {{"p_eff_kPa", "kPa"}, {"q_kPa", "kPa"}},
      .rows = {}};
  for (const char* name : {"eta_first_unstable", "eta_isotropic_unloading", "eta_limit"})
    add_columns(data.columns, name, "");
  for (const char* name : {"alpha", "cone_from", "cone_to"}) add_columns(data.columns, name, "°");
  const double degree = sim::radians(1);
  for (const auto* side : {&d.compression, &d.extension})
    for (const ImpliedBoundary& at : *side) {
      auto& row = data.rows.emplace_back();
      row = {at.p / 1e3, std::nullopt};
      add_value(row, at.first_unstable, 1);
      add_value(row, at.isotropic_unloading, 1);
      add_value(row, at.limit, 1);
      add_value(row, at.first_angle, degree);
      row.resize(data.columns.size());
    }
  for (const ImpliedCone& cone : d.cones) {
    auto& row = data.rows.emplace_back();
    row = {cone.p / 1e3, cone.q / 1e3};
    row.resize(data.columns.size() - 8);
    add_value(row, cone.from, degree);
    add_value(row, cone.to, degree);
  }
  return data;
}

}  // namespace

NamedFigure implied_domain_figure(const study::Calibration& calibration) {
  return {"domain", Picture(calibration).draw(), data_of(calibration)};
}

}  // namespace triax::src
