// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/soil/soil_figures.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/soil/figures/critical_state_figures.hpp"
#include "src/soil/figures/mohr_figure.hpp"
#include "src/soil/figures/trend_figure.hpp"

namespace triax::src {
namespace {

constexpr const char* kState = "state parameter ψ₀";

void add_onsets(const study::Soil& soil, std::vector<NamedFigure>& figures) {
  for (const auto& of : soil.onsets) {
    if (!of.over_state) continue;
    const std::string kind(lab::to_string(of.kind));
    const std::string sense = of.extension ? "extension" : "compression";
    figures.push_back(trend_figure(
        soil, *of.over_state,
        {.name = "onset_" + kind + (of.extension ? "_extension" : ""),
         .x_title = kState,
         .y_title = "stress ratio η at the onset of collapse",
         .x_column = "state_parameter",
         .y_column = "eta",
         .caption = fmt::format("Stress ratio at the onset of {} in {} over the state parameter.",
                                kind == "limited" ? "limited collapse" : kind, sense)}));
  }
}

void add_peaks(const study::Soil& soil, std::vector<NamedFigure>& figures) {
  if (soil.stress_dilatancy)
    figures.push_back(
        trend_figure(soil, *soil.stress_dilatancy,
                     {.name = "stress_dilatancy",
                      .x_title = "dilatancy at the peak −dε_v/dε_q",
                      .y_title = "stress ratio η at the peak",
                      .x_column = "minus_dilatancy",
                      .y_column = "eta_peak",
                      .caption = "Stress ratio at the peak over the dilatancy there."}));
  if (soil.dilatancy_over_state)
    figures.push_back(trend_figure(soil, *soil.dilatancy_over_state,
                                   {.name = "dilatancy_over_state",
                                    .x_title = kState,
                                    .y_title = "dilatancy at the peak dε_v/dε_q",
                                    .x_column = "state_parameter",
                                    .y_column = "dilatancy",
                                    .caption = "Dilatancy at the peak over the state parameter."}));
  if (soil.strength_over_state)
    figures.push_back(
        trend_figure(soil, *soil.strength_over_state,
                     {.name = "undrained_strength",
                      .x_title = kState,
                      .y_title = "undrained strength q_peak/(2 p′₀)",
                      .x_column = "state_parameter",
                      .y_column = "strength_ratio",
                      .caption = "Normalised undrained strength over the state parameter."}));
}

void add_cyclic(const study::Soil& soil, std::vector<NamedFigure>& figures) {
  for (const auto& of : soil.cyclic) {
    const bool pressure = of.criterion == "pore_pressure_ratio";
    figures.push_back(trend_figure(
        soil, of.trend,
        {.name = "cyclic_resistance_" + of.criterion,
         .x_title = pressure ? "cycles N to r_u = 0.95" : "cycles N to 5 % double amplitude",
         .y_title = "cyclic stress ratio CSR",
         .x_column = "cycles",
         .y_column = "csr",
         .caption = pressure ? "Cyclic resistance to r_u = 0.95."
                             : "Cyclic resistance to 5 % double amplitude.",
         .x_of = [](double x) { return std::exp(x); },
         .y_of = [](double y) { return std::exp(y); },
         .x_logarithmic = true}));
  }
}

}  // namespace

std::vector<NamedFigure> soil_figures(const study::Soil& soil) {
  std::vector<NamedFigure> figures;
  if (soil.critical_line) figures.push_back(critical_line_figure(soil));
  if (soil.critical_ratio || soil.extension_ratio) figures.push_back(critical_ratio_figure(soil));
  if (soil.strength) figures.push_back(mohr_figure(soil));
  add_peaks(soil, figures);
  add_onsets(soil, figures);
  add_cyclic(soil, figures);
  return figures;
}

}  // namespace triax::src
