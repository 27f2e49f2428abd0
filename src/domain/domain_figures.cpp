#include "src/domain/domain_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/mechanics/units.hpp"
#include "src/domain/domain_figure.hpp"

namespace triax::src {
namespace {

constexpr double kPa = 1e3;

Subject subject_of(const study::ReportedDomain& domain) {
  return {.material = domain.settings.material.name,
          .state = fmt::format("e = {:g}", domain.settings.grid.void_ratio),
          .plane = study::domain_grid(domain.settings.grid).plane};
}

/// Some of `count` indices: the last, and others at equal steps before it.
std::vector<std::size_t> spread(std::size_t count) {
  const std::size_t step = std::max<std::size_t>(1, (count + kMostFans - 1) / kMostFans);
  std::vector<std::size_t> indices;
  for (std::size_t i = (count - 1) % step; i < count; i += step) indices.push_back(i);
  return indices;
}

/// The states at which a criterion of one side is met.
std::vector<TriaxialState> line(const study::ReportedDomain& domain,
                                study::ReportedBoundary study::ReportedColumn::*side,
                                std::optional<study::DomainMark> study::ReportedBoundary::*mark) {
  std::vector<TriaxialState> states;
  for (const auto& column : domain.columns)
    if (const auto& at = column.*side.*mark)
      states.push_back({column.p_eff_kPa * kPa, at->q_kPa * kPa});
  return states;
}

ConesPicture picture_of(const study::ReportedDomain& domain,
                        const std::vector<study::TestedState>& tests) {
  ConesPicture picture{.subject = subject_of(domain)};
  for (const std::size_t i : spread(domain.columns.size())) {
    const study::ReportedColumn& column = domain.columns[i];
    for (const std::size_t j : spread(column.states.size())) {
      const study::ReportedDomainState& state = column.states[j];
      if (state.kind != sim::DomainStateKind::stable &&
          state.kind != sim::DomainStateKind::unstable)
        continue;
      ConesAtState at{{column.p_eff_kPa * kPa, state.q_kPa * kPa}, {}};
      for (const auto& [from, to] : state.cones_deg)
        at.cones.push_back({sim::radians(from), sim::radians(to)});
      picture.states.push_back(std::move(at));
    }
  }
  for (const auto side : {&study::ReportedColumn::compression, &study::ReportedColumn::extension}) {
    picture.boundaries.push_back(line(domain, side, &study::ReportedBoundary::first_unstable));
    picture.limits.push_back(line(domain, side, &study::ReportedBoundary::limit));
    picture.instability_lines.push_back(
        line(domain, side, &study::ReportedBoundary::isotropic_unloading));
  }
  const auto short_line = [](const auto& states) { return states.size() < 2; };
  std::erase_if(picture.boundaries, short_line);
  std::erase_if(picture.limits, short_line);
  std::erase_if(picture.instability_lines, short_line);
  for (const study::TestedState& test : tests) {
    const auto& s = test.state;
    if (test.increment)
      picture.tests.push_back({test.name,
                               {s.p_eff, s.q},
                               test.increment->angle,
                               test.origin == lab::Origin::simulated});
  }
  return picture;
}

/// A row a cone, or a stable state; then a row a test.
FigureData data_of(const study::ReportedDomain& domain, const ConesPicture& picture) {
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
    if (at.cones.empty()) data.rows.push_back({at.state.p / kPa, at.state.q / kPa, {}, {}, {}});
    for (const auto& [from, to] : at.cones)
      data.rows.push_back(
          {at.state.p / kPa, at.state.q / kPa, sim::degrees(from), sim::degrees(to), {}});
  }
  for (const auto& test : picture.tests) {
    data.remarks.push_back(fmt::format("test_alpha_deg: {}, {}", test.name,
                                       test.simulated ? "simulated" : "recorded"));
    data.rows.push_back({test.state.p / kPa, test.state.q / kPa, {}, {}, sim::degrees(test.angle)});
  }
  return data;
}

}  // namespace

Drawing domain_map(const study::ReportedDomain& domain) {
  return domain_figure(study::domain_grid(domain.settings.grid), study::domain_columns(domain),
                       subject_of(domain));
}

std::vector<NamedFigure> domain_cones(const study::ReportedDomain& domain,
                                      const std::vector<study::TestedState>& tests) {
  std::vector<NamedFigure> figures;
  if (study::domain_grid(domain.settings.grid).plane != sim::ProbePlane::axisymmetric) return figures;
  const ConesPicture picture = picture_of(domain, tests);
  for (const auto& [name, plane] :
       {std::pair("cones_pq", StressAxes::p_q), std::pair("cones_rendulic", StressAxes::rendulic)})
    if (Drawing drawing = cones_figure(picture, plane); drawing.plot)
      figures.push_back({name, std::move(drawing), data_of(domain, picture)});
  return figures;
}

}  // namespace triax::src
