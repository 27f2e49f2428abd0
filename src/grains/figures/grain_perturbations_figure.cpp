// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/figures/grain_perturbations_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "src/plot/axes.hpp"
#include "src/plot/energy_axis.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"

namespace triax::src {
namespace {

constexpr int kPanelWidth = 480, kPanelHeight = 360, kLegendHeight = 30;
constexpr int kMaxColumns = 3;
/// χ of a state at rest moves by less; a range so narrow would show noise only.
constexpr double kLeastChi = 0.005;

QPen share_pen() { return line(kBlue, 1.8); }
QPen energy_pen() { return line(kVermilion, 1.4, Qt::DashLine); }

void colour(QCPAxis& axis, const QColor& colour, const char* title) {
  axis.setLabel(QString::fromUtf8(title));
  axis.setLabelColor(colour);
  axis.setTickLabelColor(colour);
}

void style_panel(QCPAxisRect& rect, const std::string& title, double unit) {
  style_axes(rect, unit == 1 ? "time t (s)" : "time t (ms)", "");
  colour(*rect.axis(QCPAxis::atLeft), kBlue, "χ = (σ₁ − σ₃/R) / (σ₁ − σ₃/R)₀");
  auto& right = *rect.axis(QCPAxis::atRight);
  right.setTicks(true);
  right.setTickLabels(true);
  right.setTickLengthOut(5);
  right.setSubTickLengthOut(2);
  colour(right, kVermilion, "kinetic energy K (J)");
  auto& top = *rect.axis(QCPAxis::atTop);
  top.setLabel(QString::fromStdString(title));
  top.setLabelFont(title_font());
}

void draw_energy(QCPAxisRect& rect, const Points& points) {
  auto* curve = draw_curve(rect, points, energy_pen());
  curve->setValueAxis(rect.axis(QCPAxis::atRight));
}

void fill(QCPAxisRect& rect, const std::vector<sim::PerturbationPoint>& points, double unit) {
  RangeOf time, chi;
  EnergyRange energies;
  time.add(0);
  for (const auto& at : points) {
    time.add(at.time_s / unit);
    chi.add(at.stress_share);
    energies.add(at.kinetic_energy_j);
  }
  chi.widen_to(kLeastChi);
  rect.axis(QCPAxis::atBottom)->setRange(time.with_margin(0.02, true));
  rect.axis(QCPAxis::atLeft)->setRange(chi.with_margin(0.08, false));
  energies.apply(*rect.axis(QCPAxis::atRight));
  Points share, energy;
  for (const auto& at : points) {
    share.emplace_back(at.time_s / unit, at.stress_share);
    const bool shown = at.kinetic_energy_j > 0 || !energies.logarithmic();
    energy.emplace_back(at.time_s / unit,
                        shown ? at.kinetic_energy_j : std::numeric_limits<double>::quiet_NaN());
  }
  draw_energy(rect, energy);
  draw_curve(rect, share, share_pen());
}

/// Seconds, or milliseconds where no panel lasts a second.
double unit_of_time(const std::vector<DrawnPerturbation>& drawn) {
  const bool long_ones =
      std::ranges::any_of(drawn, [](const auto& one) { return one.points.back().time_s >= 1; });
  return long_ones ? 1 : 1e-3;
}

}  // namespace

Drawing grain_perturbations_figure(const std::vector<DrawnPerturbation>& all,
                                   const Subject& subject) {
  std::vector<DrawnPerturbation> drawn;
  std::ranges::copy_if(all, std::back_inserter(drawn),
                       [](const auto& one) { return !one.points.empty(); });
  if (drawn.empty()) return {};
  const int count = static_cast<int>(drawn.size()), columns = std::min(count, kMaxColumns),
            rows = (count + columns - 1) / columns;
  auto plot = make_plot(columns * kPanelWidth, rows * kPanelHeight + kLegendHeight + kOriginHeight);
  const auto panels = add_axes_in_rows(*plot, count, columns);
  const double unit = unit_of_time(drawn);
  draw_curve(*panels.front(), {}, share_pen(), "χ, left axis");
  draw_curve(*panels.front(), {}, energy_pen(), "kinetic energy, right axis");
  legend_below(*plot, 2);
  origin_below(*plot, subject);
  std::string titles;
  for (int i = 0; i < count; ++i) {
    style_panel(*panels[i], drawn[i].title, unit);
    fill(*panels[i], drawn[i].points, unit);
    titles += (i > 0 ? "; " : "") + drawn[i].title;
  }
  return {std::move(plot),
          fmt::format("σ₁ − σ₃/R over what it was at the start and kinetic energy after a "
                      "perturbation: {}. {}",
                      titles, simulated_with(subject))};
}

}  // namespace triax::src
