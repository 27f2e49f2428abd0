// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/stress_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

// Ends at the border: what a plot cuts off on a screen, an SVG without clipping would show.
QCPGraph* draw_ray(QCustomPlot& plot, double slope, const std::string& name, const QPen& pen) {
  const double p_end = slope > 0
                           ? std::min(plot.xAxis->range().upper, plot.yAxis->range().upper / slope)
                           : plot.xAxis->range().upper;
  auto* ray = plot.addGraph();
  ray->addData(0, 0);
  ray->addData(p_end, std::max(slope * p_end, plot.yAxis->range().lower));
  ray->setPen(pen);
  ray->setName(QString::fromStdString(name));
  return ray;
}

std::string angle(double slope) {
  const double phi = sim::degrees(sim::mobilised_friction_angle(slope));
  return std::isfinite(phi) ? fmt::format(", φ = {:.1f}°", phi) : std::string();
}

}  // namespace

void draw_instability_line(QCustomPlot& plot, double eta) {
  draw_ray(plot, eta, fmt::format("instability line (η = {:.2f}{})", eta, angle(eta)),
           line(kVermilion, 1.4, Qt::DashLine));
}

void draw_mohr_coulomb_line(QCustomPlot& plot, double limit_stress_ratio) {
  draw_ray(plot, limit_stress_ratio,
           fmt::format("Mohr-Coulomb line (M = {:.2f}{})", limit_stress_ratio,
                       angle(limit_stress_ratio)),
           line(kInk, 1.4));
}

void draw_mohr_coulomb_lines(QCustomPlot& plot, const std::vector<double>& limit_stress_ratios) {
  if (limit_stress_ratios.size() <= 2) {
    for (const double m : limit_stress_ratios) draw_mohr_coulomb_line(plot, m);
    return;
  }
  const auto name = fmt::format("Mohr-Coulomb lines (M = {:.2f} to {:.2f})",
                                limit_stress_ratios.front(), limit_stress_ratios.back());
  for (std::size_t i = 0; i < limit_stress_ratios.size(); ++i) {
    auto* ray = draw_ray(plot, limit_stress_ratios[i], name, line(kGrey, 0.8));
    if (i > 0) ray->removeFromLegend();
  }
}

}  // namespace triax::src
