// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/sphere_figure.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/stability/cones.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/colour_steps.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/point_labels.hpp"
#include "src/plot/polar_frame.hpp"
#include "src/plot/zero_line.hpp"

namespace triax::src {
namespace {

constexpr int kSphereWidth = 960, kSphereHeight = 520 + kOriginHeight;
constexpr int kPlaces = 241;  // across a disc
constexpr double kRange = 1.2;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Base {
  Eigen::Vector3d out, right, up;
};
const Base& base() {
  static const Base kBase = {Eigen::Vector3d(1, 1, 1).normalized(),
                             Eigen::Vector3d(0, 1, -1).normalized(),
                             Eigen::Vector3d(2, -1, -1).normalized()};
  return kBase;
}

QCPColorGradient colours() {
  // The sign is seen without colour too: W₂ > 0 is light, and the line W₂ = 0 is drawn.
  constexpr int kHalf = 10;
  auto steps =
      steps_between({QColor(0x6B, 0x24, 0x00), kVermilion, QColor(0xF2, 0xAC, 0x74)}, kHalf);
  const auto positive = steps_between({QColor(0xF4, 0xF9, 0xFC), QColor(0xA4, 0xCF, 0xE8)}, kHalf);
  steps.insert(steps.end(), positive.begin(), positive.end());
  return stepped_gradient(steps);
}

/// The values of a disc; unknown outside of it.
template <class Value>
Raster disc(bool towards, const Value& value) {
  Raster raster{kPlaces, -1, 1, std::vector<double>(kPlaces * kPlaces, kUnknown)};
  auto place = raster.values.begin();
  for (int row = 0; row < kPlaces; ++row)
    for (int column = 0; column < kPlaces; ++column, ++place) {
      const QPointF at(raster.coordinate(column), raster.coordinate(row));
      if (QPointF::dotProduct(at, at) <= 1) *place = value(direction_at(at, towards));
    }
  return raster;
}

class SphereDrawing {
 public:
  SphereDrawing(const std::vector<SphereDirection>& directions, const Subject& subject)
      : directions_(directions),
        subject_(subject),
        // Of the cells that so many directions make on the sphere.
        spacing_(std::sqrt(4 * std::numbers::pi / static_cast<double>(directions.size()))) {}

  Drawing draw() {
    auto plot = make_plot(kSphereWidth, kSphereHeight);
    auto& left = *plot->axisRect();
    auto& right = add_axes_beside(*plot);
    auto* bar = add_colour_bar(*plot);
    draw_curve(left, {}, edge_pen(), "W₂ = 0");
    draw_curve(left, {}, axisymmetric_pen(), "axisymmetric plane");
    draw_curve(left, {}, plane_strain_pen(), "plane strain, dε₂ = 0");
    legend_below(*plot, 3);
    origin_below(*plot, subject_);
    for (auto* rect : {&left, &right}) {
      hide_axes(*rect);
      set_equal_ranges(*rect, {-kRange, kRange}, {-kRange, kRange});
    }
    draw_disc(left, true, *bar);
    draw_disc(right, false, *bar);
    return {std::move(plot), caption()};
  }

 private:
  static QPen edge_pen() { return line(kInk, 1.8); }
  static QPen axisymmetric_pen() { return line(kInk, 1.2, Qt::DashLine); }
  static QPen plane_strain_pen() { return line(kGreen, 2, Qt::DotLine); }

  static QCPColorScale* add_colour_bar(QCustomPlot& plot) {
    auto* bar = new QCPColorScale(&plot);
    plot.plotLayout()->addElement(0, 1, bar);
    bar->setType(QCPAxis::atRight);
    bar->setBarWidth(14);
    bar->setGradient(colours());
    bar->setDataRange({-1, 1});
    bar->axis()->setLabel("normalised W₂ (–)");
    bar->axis()->setLabelFont(title_font());
    bar->axis()->setTickLabelFont(label_font());
    bar->setMargins(QMargins(0, 40, 12, 40));
    bar->setAutoMargins(QCP::msRight | QCP::msLeft);
    return bar;
  }

  const SphereDirection& nearest(const Eigen::Vector3d& direction) const {
    return *std::ranges::max_element(directions_, {}, [&](const SphereDirection& given) {
      return given.direction.dot(direction);
    });
  }

  /// A value between the directions given, by a curved surface through the neighbours (least
  /// squares); unknown where the law has no answer.
  template <class Value>
  double between(const Eigen::Vector3d& direction, const Value& value) const {
    using Terms = Eigen::Matrix<double, 6, 1>;
    using Squares = Eigen::Matrix<double, 6, 6>;
    const Eigen::Vector3d across = direction.unitOrthogonal(), along = direction.cross(across);
    Squares squares = Squares::Zero();
    Terms sums = Terms::Zero();
    double nearest = std::numeric_limits<double>::infinity();
    bool answered = false;
    for (const auto& given : directions_) {
      const Eigen::Vector3d way = (given.direction - direction) / spacing_;
      const double distance = way.squaredNorm();
      if (distance > 5) continue;
      if (distance < nearest) answered = given.answered;
      nearest = std::min(nearest, distance);
      if (!given.answered) continue;
      const double x = way.dot(across), y = way.dot(along);
      const Terms terms = (Terms() << 1, x, y, x * x, x * y, y * y).finished();
      const double weight = std::exp(-distance);
      squares += weight * terms * terms.transpose();
      sums += weight * value(given) * terms;
    }
    const Eigen::LDLT<Squares> solver(squares);
    return answered && solver.rcond() > 1e-8 ? solver.solve(sums)(0) : kUnknown;
  }

  /// Component 2 of the strain's direction.
  double lateral_strain(const Eigen::Vector3d& direction) const {
    if (subject_.kind == sim::ProbeKind::strain) return direction(1);
    return between(direction, [](const SphereDirection& given) {
      return given.response(1) / given.response.norm();
    });
  }

  double smooth_work(const Eigen::Vector3d& direction) const {
    return between(direction, [](const SphereDirection& given) { return given.normalised; });
  }

  void draw_disc(QCPAxisRect& rect, bool towards, QCPColorScale& bar) {
    const Raster work = disc(towards, [this](const Eigen::Vector3d& direction) {
      const auto& given = nearest(direction);
      return given.answered ? given.normalised : kUnknown;
    });
    draw_map(rect, work, bar);
    const Raster smooth =
        disc(towards, [this](const auto& direction) { return smooth_work(direction); });
    draw_curve(rect, zero_line(smooth), edge_pen());
    draw_curve(rect, {{0, -1}, {0, 1}}, axisymmetric_pen());
    const Raster lateral =
        disc(towards, [this](const auto& direction) { return lateral_strain(direction); });
    draw_curve(rect, zero_line(lateral), plane_strain_pen());
    draw_curve(rect, circle_of(1), line(kInk, 1.8));
    const std::string symbol = subject_.kind == sim::ProbeKind::stress ? "dσ" : "dε";
    write_text(rect, {0, 1.06},
               fmt::format("{0}₁ + {0}₂ + {0}₃ {1} 0", symbol, towards ? '>' : '<'), kInk,
               Qt::AlignHCenter | Qt::AlignBottom);
    mark_axes(rect, towards, symbol);
  }

  static void draw_map(QCPAxisRect& rect, const Raster& work, QCPColorScale& bar) {
    auto* map = new QCPColorMap(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    map->removeFromLegend();
    map->setInterpolate(false);
    map->setAntialiased(false);
    map->data()->setSize(kPlaces, kPlaces);
    map->data()->setRange({-1, 1}, {-1, 1});
    map->data()->fill(0);
    map->data()->fillAlpha(0);
    for (int row = 0; row < kPlaces; ++row)
      for (int column = 0; column < kPlaces; ++column)
        if (std::hypot(work.coordinate(column), work.coordinate(row)) <= 1) {
          map->data()->setCell(column, row, work.at(column, row));
          map->data()->setAlpha(column, row, 255);
        }
    map->setGradient(colours());
    map->setDataRange({-1, 1});
    map->setColorScale(&bar);
  }

  static void mark_axes(QCPAxisRect& rect, bool towards, const std::string& symbol) {
    static constexpr std::array kNumbers = {"₁", "₂", "₃"};
    Points marks;
    std::vector<PointLabel> labels;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d direction = (towards ? 1 : -1) * Eigen::Vector3d::Unit(axis);
      const QPointF at = lambert(direction, towards);
      marks.push_back(at);
      labels.push_back(
          {at.x(), at.y(),
           (towards ? "+" : "−") + symbol + kNumbers.at(static_cast<std::size_t>(axis)), kInk});
    }
    draw_markers(rect, marks, {QCPScatterStyle::ssCircle, line(kInk, 1.4), QBrush(Qt::white), 7});
    draw_markers(rect, {{0, 0}}, {QCPScatterStyle::ssPlus, line(kInk, 1.4), Qt::NoBrush, 9});
    place_labels(rect, labels);
  }

  std::string caption() const {
    const auto answered = std::ranges::count_if(directions_, &SphereDirection::answered);
    const auto unstable = std::ranges::count_if(
        directions_, [](const auto& d) { return d.answered && d.normalised < sim::kUnstable; });
    return fmt::format(
        "Normalised second-order work in all directions of the principal {} increments, as "
        "equal-area discs around the hydrostatic axis (+) towards compression (left) and away from "
        "it (right): {} of {} directions have W₂ < 0. {}",
        subject_.kind == sim::ProbeKind::stress ? "stress" : "strain", unstable, answered,
        simulated_with(subject_));
  }

  const std::vector<SphereDirection>& directions_;
  const Subject& subject_;
  double spacing_;
};

}  // namespace

QPointF lambert(const Eigen::Vector3d& direction, bool towards) {
  const double out = (towards ? 1 : -1) * direction.dot(base().out);
  const double scale = std::sqrt(1 / (1 + out));
  return {scale * direction.dot(base().right), scale * direction.dot(base().up)};
}

Eigen::Vector3d direction_at(const QPointF& place, bool towards) {
  const double squared = QPointF::dotProduct(place, place);
  return (towards ? 1 : -1) * (1 - squared) * base().out +
         std::sqrt(2 - squared) * (place.x() * base().right + place.y() * base().up);
}

Drawing sphere_figure(const std::vector<SphereDirection>& directions, const Subject& subject) {
  if (std::ranges::none_of(directions, &SphereDirection::answered)) return {};
  return SphereDrawing(directions, subject).draw();
}

}  // namespace triax::src
