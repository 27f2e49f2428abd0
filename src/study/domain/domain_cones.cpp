// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_cones.hpp"

#include <algorithm>

#include "sim/mechanics/units.hpp"

namespace triax::study {
namespace {

/// Some of `count` indices: the last, and others at equal steps before it.
std::vector<std::size_t> spread(std::size_t count) {
  const std::size_t step = std::max<std::size_t>(1, (count + kMostFans - 1) / kMostFans);
  std::vector<std::size_t> indices;
  for (std::size_t i = (count - 1) % step; i < count; i += step) indices.push_back(i);
  return indices;
}

/// The states at which a criterion of one side is met.
std::vector<TriaxialState> line(const ReportedDomain& domain,
                                ReportedBoundary ReportedColumn::*side,
                                std::optional<DomainMark> ReportedBoundary::*mark) {
  std::vector<TriaxialState> states;
  for (const auto& column : domain.columns)
    if (const auto& at = column.*side.*mark)
      states.push_back({column.p_eff_kPa * kKilo, at->q_kPa * kKilo});
  return states;
}

}  // namespace

ConesPicture cones_picture(const ReportedDomain& domain, const std::vector<TestedState>& tests) {
  ConesPicture picture;
  for (const std::size_t i : spread(domain.columns.size())) {
    const ReportedColumn& column = domain.columns[i];
    for (const std::size_t j : spread(column.states.size())) {
      const ReportedDomainState& state = column.states[j];
      if (state.kind != sim::DomainStateKind::stable &&
          state.kind != sim::DomainStateKind::unstable)
        continue;
      ConesAtState at{{column.p_eff_kPa * kKilo, state.q_kPa * kKilo}, {}};
      for (const auto& [from, to] : state.cones_deg)
        at.cones.push_back({sim::radians(from), sim::radians(to)});
      picture.states.push_back(std::move(at));
    }
  }
  for (const auto side : {&ReportedColumn::compression, &ReportedColumn::extension}) {
    picture.boundaries.push_back(line(domain, side, &ReportedBoundary::first_unstable));
    picture.limits.push_back(line(domain, side, &ReportedBoundary::limit));
    picture.instability_lines.push_back(line(domain, side, &ReportedBoundary::isotropic_unloading));
  }
  const auto short_line = [](const auto& states) { return states.size() < 2; };
  std::erase_if(picture.boundaries, short_line);
  std::erase_if(picture.limits, short_line);
  std::erase_if(picture.instability_lines, short_line);
  for (const TestedState& test : tests) {
    const auto& s = test.state;
    if (test.increment)
      picture.tests.push_back({test.name,
                               {s.p_eff, s.q},
                               test.increment->angle,
                               test.origin == lab::Origin::simulated});
  }
  return picture;
}

}  // namespace triax::study
