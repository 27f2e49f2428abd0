// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/stress_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

// Ends at the border: what a plot cuts off on a screen, an SVG without clipping would show.
QCPGraph* draw_ray(QCustomPlot& plot, double slope, const std::string& name, const QPen& pen,
                   double intercept = 0) {
  const auto q = plot.yAxis->range();
  double p_end = plot.xAxis->range().upper;
  if (slope != 0) p_end = std::min(p_end, ((slope > 0 ? q.upper : q.lower) - intercept) / slope);
  auto* ray = plot.addGraph();
  ray->addData(0, intercept);
  ray->addData(p_end, intercept + slope * p_end);
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

void draw_mohr_coulomb_line(QCustomPlot& plot, double limit_stress_ratio, double intercept) {
  if (intercept >= plot.yAxis->range().upper) return;  // all of it is above the plot
  draw_ray(plot, limit_stress_ratio,
           fmt::format("Mohr-Coulomb line (M = {:.2f}{}{})", limit_stress_ratio,
                       angle(limit_stress_ratio),
                       intercept > 0 ? fmt::format(", k = {:.1f} kPa", intercept) : ""),
           line(kInk, 1.4), intercept);
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

std::string instability_words(const std::vector<double>& etas) {
  if (etas.size() == 1) return fmt::format("η = {:.2f}", etas.front());
  return fmt::format("η = {:.2f} in compression, {:.2f} in extension", etas.front(), etas.back());
}

}  // namespace triax::src
