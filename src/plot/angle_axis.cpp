// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/angle_axis.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

constexpr int kLight = 45;  // of 255

void shade(QCPAxisRect& rect, double from, double to, QColor fill, const std::string& name) {
  const auto range = rect.axis(QCPAxis::atLeft)->range();
  fill.setAlpha(kLight);
  auto* area = draw_area(
      rect, {{from, range.lower}, {to, range.lower}, {to, range.upper}, {from, range.upper}}, fill,
      Qt::NoPen, name);
  lay_behind(*area);
}

}  // namespace

void style_angle_axes(QCPAxisRect& rect, sim::ProbePlane plane, sim::ProbeKind kind,
                      const std::string& y_title, double step_deg) {
  const bool stress = kind == sim::ProbeKind::stress;
  style_axes(
      rect,
      fmt::format("direction α of the {} increment from {} (°)", stress ? "stress" : "strain",
                  stress ? stress_x_name(plane) : strain_x_name(plane)),
      y_title);
  const QSharedPointer<QCPAxisTickerFixed> ticker(new QCPAxisTickerFixed);
  ticker->setTickStep(step_deg);
  rect.axis(QCPAxis::atBottom)->setTicker(ticker);
  rect.axis(QCPAxis::atBottom)->setRange(0, kTurnDeg);
}

void shade_directions(QCPAxisRect& rect, double from_deg, double to_deg, const QColor& colour,
                      const std::string& name) {
  if (from_deg < 0) {
    shade(rect, from_deg + kTurnDeg, kTurnDeg, colour, "");
    from_deg = 0;
  }
  shade(rect, from_deg, std::min(to_deg, kTurnDeg), colour, name);
  if (to_deg > kTurnDeg) shade(rect, 0, to_deg - kTurnDeg, colour, "");
}

}  // namespace triax::src
