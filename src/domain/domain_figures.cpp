// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/domain/domain_figures.hpp"

#include <fmt/format.h>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/domain/figures/domain_figure.hpp"

namespace triax::src {
namespace {

Subject subject_of(const study::ReportedDomain& domain) {
  return {.material = domain.settings.material.name,
          .state = fmt::format("e = {:g}", domain.settings.grid.void_ratio),
          .plane = study::domain_grid(domain.settings.grid).plane};
}

/// A row a cone, or a stable state; then a row a test.
FigureData data_of(const study::ReportedDomain& domain, const study::ConesPicture& picture) {
  FigureData data{.title = "cones of unstable directions, " + domain.settings.material.name,
                  .origin = "simulated",
                  .remarks = {"law: " + domain.settings.material.law,
                              fmt::format("void ratio {:g}", domain.settings.grid.void_ratio)},
                  .columns = {{"p_eff_kPa", "kPa"},
                              {"q_kPa", "kPa"},
                              {"cone_from_deg", "°"},
                              {"cone_to_deg", "°"},
                              {"test_alpha_deg", "°"}},
                  .rows = {}};
  for (const auto& at : picture.states) {
    if (at.cones.empty())
      data.rows.push_back({at.state.p / study::kKilo, at.state.q / study::kKilo, {}, {}, {}});
    for (const auto& [from, to] : at.cones)
      data.rows.push_back({at.state.p / study::kKilo,
                           at.state.q / study::kKilo,
                           sim::degrees(from),
                           sim::degrees(to),
                           {}});
  }
  for (const auto& test : picture.tests) {
    data.remarks.push_back(fmt::format("test_alpha_deg: {}, {}", test.name,
                                       test.simulated ? "simulated" : "recorded"));
    data.rows.push_back({test.state.p / study::kKilo,
                         test.state.q / study::kKilo,
                         {},
                         {},
                         sim::degrees(test.angle)});
  }
  return data;
}

}  // namespace

Drawing domain_map(const study::ReportedDomain& domain) {
  return domain_figure(study::domain_grid(domain.settings.grid), study::domain_columns(domain),
                       subject_of(domain));
}

std::vector<NamedFigure> domain_cones(const study::ReportedDomain& domain,
                                      const study::ConesPicture& picture) {
  std::vector<NamedFigure> figures;
  for (const auto& [name, plane] :
       {std::pair("cones_pq", StressAxes::p_q), std::pair("cones_rendulic", StressAxes::rendulic)})
    if (Drawing drawing = cones_figure(picture, subject_of(domain), plane); drawing.plot)
      figures.push_back({name, std::move(drawing), data_of(domain, picture)});
  return figures;
}

}  // namespace triax::src
