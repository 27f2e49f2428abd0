// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/domain/figures/domain_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "sim/mechanics/axisymmetric.hpp"
#include "sim/stability/domain_criteria.hpp"
#include "src/plot/colour_steps.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/probe/figures/cones_figure.hpp"

namespace triax::src {
namespace {

constexpr int kDomainWidth = 720, kDomainHeight = 560 + kOriginHeight;
const QColor kUnknown(0xD6, 0xE6, 0xF2);

/// Light to dark away from the domain's boundary, so that a print without colour shows the same
/// order.
QCPColorGradient colours(int levels) {
  const std::vector<QColor> stops = {QColor(0xFE, 0xF0, 0xD0), QColor(0xF7, 0xC0, 0x7A), kVermilion,
                                     QColor(0x6B, 0x24, 0x00)};
  return stepped_gradient(steps_between(stops, levels));
}

/// Range of the colour bar in round levels.
struct Scale {
  QCPRange range{0, 1};
  int levels = 1;
};

Scale scale_of(const std::vector<sim::DomainColumn>& columns) {
  double most = 0;
  for (const auto& column : columns)
    for (const auto& state : column.states) most = std::max(most, domain_value(state).value_or(0));
  double step = 5;
  for (const double factor : {2.0, 2.0, 2.5, 2.0})
    if (most > 12 * step) step *= factor;
  Scale scale;
  scale.levels = std::max(1, static_cast<int>(std::ceil(most / step - 1e-9)));
  scale.range = QCPRange(0, step * scale.levels);
  return scale;
}

using Side = sim::DomainBoundary sim::DomainColumn::*;
using Criterion = std::function<std::optional<double>(const sim::DomainBoundary&)>;
constexpr std::array<Side, 2> kSides = {&sim::DomainColumn::compression,
                                        &sim::DomainColumn::extension};

struct BoundaryLook {
  Criterion criterion;
  std::string name;
  QPen pen;
  bool dots = false;  ///< on the line that it may lie on; else a line
};

/// Criteria of the list that are dots, or lines; each has a colour of its own by its place in it.
void add_others(bool dots, std::vector<BoundaryLook>& all) {
  const std::array colours = {kPurple, kGreen, kOrange};
  std::size_t place = 0;
  for (const auto& kind : sim::domain_criterion_kinds()) {
    const QColor& colour = colours[place++ % colours.size()];
    if (kind.dots != dots) continue;
    all.push_back({[name = kind.name](const sim::DomainBoundary& b) { return b.other_q(name); },
                   std::string(kind.legend),
                   dots ? line(colour, 1.4) : line(colour, 2, Qt::DashDotLine), dots});
  }
}

std::vector<BoundaryLook> looks(const Subject& subject) {
  std::vector<BoundaryLook> all = {
      {&sim::DomainBoundary::limit_q, "plastic limit", line(kInk, 1.4)}};
  add_others(false, all);
  all.push_back({&sim::DomainBoundary::isotropic_unloading_q,
                 subject.plane == sim::ProbePlane::axisymmetric ? "isotropic unloading (215.26°)"
                                                                : "isotropic unloading (225°)",
                 line(kInk, 1.8, Qt::DashLine)});
  all.push_back(
      {&sim::DomainBoundary::first_unstable_q, "first unstable direction", line(kBlue, 2.2)});
  add_others(true, all);
  return all;
}

QCPScatterStyle dot(const QPen& pen) {
  return {QCPScatterStyle::ssCircle, pen, QBrush(Qt::white), 6};
}

/// Of the points known some, evenly spread: as many as can be told from each other.
Points some_of(const Points& points) {
  constexpr std::size_t kMost = 16;
  Points known, some;
  std::ranges::copy_if(points, std::back_inserter(known),
                       [](const QPointF& p) { return std::isfinite(p.y()); });
  const std::size_t count = std::min(kMost, known.size());
  for (std::size_t i = 0; i < count; ++i)
    some.push_back(known[(2 * i + 1) * known.size() / (2 * count)]);
  return some;
}

/// The criterion over p′ on one side, kPa; a gap where a column has none.
Points boundary(const std::vector<sim::DomainColumn>& columns, Side side,
                const Criterion& criterion) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  Points points;
  for (const auto& column : columns) {
    const auto q = criterion(column.*side);
    points.emplace_back(column.p * 1e-3, q ? *q * 1e-3 : kGap);
  }
  return points;
}

bool any_point(const Points& points) {
  return std::ranges::any_of(points, [](const QPointF& p) { return std::isfinite(p.y()); });
}

class Map {
 public:
  Map(const sim::DomainGrid& grid, const std::vector<sim::DomainColumn>& columns,
      const Subject& subject)
      : grid_(grid),
        columns_(columns),
        subject_(subject),
        plot_(make_plot(kDomainWidth, kDomainHeight)) {
    std::ranges::sort(columns_, {}, &sim::DomainColumn::column);
  }

  Drawing draw() {
    style_axes(rect(), "mean effective stress p′ (kPa)", "deviator stress q (kPa)");
    plot_->xAxis->setRange(std::min(0.0, grid_.p_from * 1e-3), grid_.p_to * 1e-3 + half_p());
    plot_->yAxis->setRange(grid_.q_from * 1e-3 - half_q(), grid_.q_to * 1e-3 + half_q());
    draw_map();
    draw_area(rect(), {}, kNoValue, line(kGrey, 0.8),
              "beyond the limit, or out of range of the law");
    draw_unknown();
    draw_boundaries();
    legend_below(*plot_, 2);
    origin_below(*plot_, subject_);
    plot_->replot();
    draw_directions();
    return {std::move(plot_), caption()};
  }

 private:
  QCPAxisRect& rect() { return *plot_->axisRect(); }
  double half_p() const {
    return grid_.columns > 1 ? (grid_.p_to - grid_.p_from) * 0.5e-3 / (grid_.columns - 1) : 0;
  }
  double half_q() const {
    return grid_.rows > 1 ? (grid_.q_to - grid_.q_from) * 0.5e-3 / (grid_.rows - 1) : 0;
  }

  /// A map of the grid's cells, all of them transparent.
  QCPColorMap* add_map() {
    auto* map = new QCPColorMap(plot_->xAxis, plot_->yAxis);
    map->removeFromLegend();
    map->setInterpolate(false);
    map->setTightBoundary(false);
    map->setAntialiased(false);
    map->data()->setSize(grid_.columns, grid_.rows);
    map->data()->setRange({grid_.p_from * 1e-3, grid_.p_to * 1e-3},
                          {grid_.q_from * 1e-3, grid_.q_to * 1e-3});
    map->data()->fill(0);
    map->data()->fillAlpha(0);
    return map;
  }

  void draw_map() {
    const auto scale = scale_of(columns_);
    auto* map = add_map();
    for (const auto& column : columns_) fill(*map->data(), column);
    add_colour_bar(*map, "opening of the cones (°)");
    map->setGradient(colours(scale.levels));
    map->setDataRange(scale.range);
  }

  void fill(QCPColorMapData& data, const sim::DomainColumn& column) const {
    const int rows = std::min(grid_.rows, static_cast<int>(column.states.size()));
    for (int row = 0; row < rows; ++row) {
      const auto& state = column.states[static_cast<std::size_t>(row)];
      const auto value = domain_value(state);
      // Unknown states have a look of their own, drawn on top.
      const bool blank =
          state.kind == sim::DomainStateKind::stable || state.kind == sim::DomainStateKind::unknown;
      constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
      data.setCell(column.column, row, blank ? 0 : value.value_or(kNone));
      data.setAlpha(column.column, row, blank ? 0 : 255);
    }
  }

  /// Neither white as stable states nor grey as states without an answer.
  void draw_unknown() {
    auto* map = add_map();
    bool any = false;
    for (const auto& column : columns_)
      for (std::size_t row = 0; row < column.states.size(); ++row)
        if (column.states[row].kind == sim::DomainStateKind::unknown) {
          map->data()->setAlpha(column.column, static_cast<int>(row), 255);
          any = true;
        }
    QCPColorGradient one_colour;
    one_colour.setColorStops({{0, kUnknown}, {1, kUnknown}});
    map->setGradient(one_colour);
    map->setDataRange({0, 1});
    if (any)
      draw_area(rect(), {}, kUnknown, line(kGrey, 0.8),
                "no result in some directions, others stable");
    else
      plot_->removePlottable(map);
  }

  void add_colour_bar(QCPColorMap& map, const char* title) {
    auto* bar = new QCPColorScale(plot_.get());
    plot_->plotLayout()->addElement(0, 1, bar);
    bar->setType(QCPAxis::atRight);
    bar->setBarWidth(14);
    bar->axis()->setLabel(title);
    bar->axis()->setLabelFont(title_font());
    bar->axis()->setTickLabelFont(label_font());
    bar->axis()->setLabelColor(kInk);
    bar->axis()->setTickLabelColor(kInk);
    bar->axis()->setBasePen(line(kInk, 1));
    bar->axis()->setTickPen(line(kInk, 1));
    bar->axis()->setSubTicks(false);
    map.setColorScale(bar);
    auto* group = new QCPMarginGroup(plot_.get());
    rect().setMarginGroup(QCP::msBottom | QCP::msTop, group);
    bar->setMarginGroup(QCP::msBottom | QCP::msTop, group);
  }

  void draw_boundaries() {
    for (const auto& look : looks(subject_)) {
      std::string name = look.name;
      for (const Side side : kSides) {
        const auto points = boundary(columns_, side, look.criterion);
        if (!any_point(points)) continue;
        if (look.dots)
          draw_markers(rect(), some_of(points), dot(look.pen), name);
        else
          draw_curve(rect(), points, look.pen, name);
        name.clear();
      }
    }
  }

  /// A few columns of a side, evenly spread, whose first unstable direction is known.
  std::vector<const sim::DomainColumn*> columns_with_arrows(Side side) const {
    constexpr std::size_t kArrows = 3;
    std::vector<const sim::DomainColumn*> known, chosen;
    for (const auto& column : columns_)
      if ((column.*side).first_unstable_q && (column.*side).first_unstable_angle)
        known.push_back(&column);
    const std::size_t count = std::min(kArrows, known.size());
    for (std::size_t i = 0; i < count; ++i)
      chosen.push_back(known[(2 * i + 1) * known.size() / (2 * count)]);
    return chosen;
  }

  // The arrows have one length on the page: what they show is where they point. In plane strain an
  // increment has a dσ₂ of its own, and the p′-q plane does not hold it.
  void draw_directions() {
    constexpr double kLength = 24, kHead = 6;  // px
    if (subject_.plane != sim::ProbePlane::axisymmetric) return;
    const double x_unit = rect().width() / plot_->xAxis->range().size();
    const double y_unit = rect().height() / plot_->yAxis->range().size();
    for (const Side side : kSides)
      for (const auto* column : columns_with_arrows(side)) {
        const auto& at = column->*side;
        const QPointF from(column->p * 1e-3, *at.first_unstable_q * 1e-3);
        const QPointF way = increment(*at.first_unstable_angle, StressAxes::p_q);
        const double pixels = std::hypot(way.x() * x_unit, way.y() * y_unit);
        draw_arrow(rect(), from, from + way * (kLength / pixels), line(kInk, 1.1), {}, kHead);
        draw_markers(rect(), {from}, {QCPScatterStyle::ssDisc, line(kInk, 1), QBrush(kInk), 4});
        has_directions_ = true;
      }
  }

  std::string caption() const {
    long unstable = 0, all = 0;
    for (const auto& column : columns_)
      for (const auto& state : column.states) {
        ++all;
        unstable += state.kind == sim::DomainStateKind::unstable ? 1 : 0;
      }
    return fmt::format(
        "Bifurcation domain in the q-p′ plane: {} of {} states have a direction with W₂ < 0, "
        "coloured by the opening of their cones{}. {}",
        unstable, all, has_directions_ ? "; arrows are the first unstable stress directions" : "",
        simulated_with(subject_));
  }

  const sim::DomainGrid& grid_;
  std::vector<sim::DomainColumn> columns_;
  const Subject& subject_;
  OwnPlot plot_;
  bool has_directions_ = false;
};

}  // namespace

std::optional<double> domain_value(const sim::DomainState& state) {
  if (state.kind != sim::DomainStateKind::unstable) return std::nullopt;
  double opening = 0;
  for (const auto& cone : state.cones) opening += cone.to - cone.from;
  return sim::degrees(opening);
}

Drawing domain_figure(const sim::DomainGrid& grid, const std::vector<sim::DomainColumn>& columns,
                      const Subject& subject) {
  if (columns.empty()) return {};
  return Map(grid, columns, subject).draw();
}

}  // namespace triax::src
