// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "sim/stability/domain_criteria.hpp"
#include "src/study/domain/domain_inputs.hpp"

namespace triax::study {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

std::optional<double> in_degrees(const std::optional<double>& rad) {
  return rad ? std::optional(*rad / kDegree) : std::nullopt;
}

std::optional<DomainMark> mark(const std::optional<double>& q, double p,
                               const std::optional<double>& angle = {}) {
  if (!q) return std::nullopt;
  return DomainMark{*q / kKilo, *q / p, in_degrees(angle)};
}

ReportedBoundary reported(const sim::DomainBoundary& b, double p) {
  ReportedBoundary out{mark(b.first_unstable_q, p, b.first_unstable_angle),
                       mark(b.isotropic_unloading_q, p),
                       mark(b.limit_q, p),
                       {}};
  for (const auto& [name, value] : b.others_q) out.others.emplace(name, *mark(value, p));
  return out;
}

ReportedDomainState reported(const sim::DomainState& state) {
  ReportedDomainState out{.q_kPa = state.q / kKilo,
                          .kind = state.kind,
                          .least_work = state.least_work,
                          .least_angle_deg = in_degrees(state.least_angle),
                          .refused_directions = state.refused_directions};
  for (const sim::Sector& cone : state.cones)
    out.cones_deg.emplace_back(cone.from / kDegree, cone.to / kDegree);
  return out;
}

std::optional<double> in_radians(const std::optional<double>& degrees) {
  return degrees ? std::optional(*degrees * kDegree) : std::nullopt;
}

sim::DomainBoundary in_si(const ReportedBoundary& b) {
  const auto q = [](const std::optional<DomainMark>& mark) {
    return mark ? std::optional(mark->q_kPa * kKilo) : std::nullopt;
  };
  sim::DomainBoundary out{.first_unstable_q = q(b.first_unstable),
                          .first_unstable_angle = b.first_unstable
                                                      ? in_radians(b.first_unstable->alpha_deg)
                                                      : std::nullopt,
                          .isotropic_unloading_q = q(b.isotropic_unloading),
                          .limit_q = q(b.limit),
                          .others_q = {}};
  for (const auto& [name, mark] : b.others) out.others_q.emplace(name, *q(mark));
  return out;
}

sim::DomainColumn in_si(const ReportedColumn& column) {
  sim::DomainColumn out{.column = column.column,
                        .p = column.p_eff_kPa * kKilo,
                        .compression = in_si(column.compression),
                        .extension = in_si(column.extension),
                        .refusal = column.refusal};
  for (const ReportedDomainState& state : column.states) {
    sim::DomainState& at = out.states.emplace_back();
    at = {.q = state.q_kPa * kKilo,
          .kind = state.kind,
          .least_work = state.least_work,
          .least_angle = in_radians(state.least_angle_deg),
          .refused_directions = state.refused_directions};
    for (const auto& [from, to] : state.cones_deg)
      at.cones.push_back({from * kDegree, to * kDegree});
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> parameters(const sim::ParameterSet& set) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& [key, value] : set.numbers) all.emplace_back(key, fmt::format("{}", value));
  for (const auto& [key, value] : set.texts) all.emplace_back(key, value);
  for (const auto& [key, values] : set.lists)
    all.emplace_back(key, fmt::format("{}", fmt::join(values, ", ")));
  return all;
}

std::vector<std::string> range_warnings(const lab::MaterialSet& material,
                                        const DomainSettings::Grid& grid) {
  std::vector<std::string> all;
  if (auto words = lab::void_ratio_outside(material, grid.void_ratio)) all.push_back(*words);
  for (const double p_kPa : {grid.p_from_kPa, grid.p_to_kPa})
    if (auto words = lab::p_eff_outside(material, p_kPa * kKilo)) all.push_back(*words);
  return all;
}

}  // namespace

const std::vector<std::string>& boundary_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> all = {"first_unstable", "isotropic_unloading"};
    for (const auto& kind : sim::domain_criterion_kinds()) all.emplace_back(kind.name);
    all.emplace_back("limit");
    return all;
  }();
  return keys;
}

bool DomainSettings::Grid::looks_for(std::string_view criterion) const {
  return std::ranges::find(criteria, criterion) != criteria.end();
}

std::optional<DomainMark> ReportedBoundary::mark(std::string_view key) const {
  if (key == "first_unstable") return first_unstable;
  if (key == "isotropic_unloading") return isotropic_unloading;
  if (key == "limit") return limit;
  const auto found = others.find(key);
  return found == others.end() ? std::nullopt : std::optional(found->second);
}

void ReportedBoundary::set_mark(std::string_view key, const std::optional<DomainMark>& mark) {
  if (key == "first_unstable")
    first_unstable = mark;
  else if (key == "isotropic_unloading")
    isotropic_unloading = mark;
  else if (key == "limit")
    limit = mark;
  else if (mark)
    others.insert_or_assign(std::string(key), *mark);
  else
    others.erase(std::string(key));
}

DomainSettings domain_settings(const lab::MaterialSet& m, const DomainSettings::Grid& grid) {
  return {{m.name, m.law->name, m.material.based_on, m.description, m.source, m.range,
           parameters(m.parameters), digests_of_files(m)},
          grid,
          range_warnings(m, grid)};
}

sim::DomainGrid domain_grid(const DomainSettings::Grid& g) {
  return {.p_from = g.p_from_kPa * kKilo,
          .p_to = g.p_to_kPa * kKilo,
          .columns = g.columns,
          .q_from = g.q_from_kPa * kKilo,
          .q_to = g.q_to_kPa * kKilo,
          .rows = g.rows,
          .void_ratio = g.void_ratio,
          .plane = g.plane == "axisymmetric" ? sim::ProbePlane::axisymmetric
                                             : sim::ProbePlane::plane_strain,
          .directions = g.directions};
}

ReportedColumn reported_column(const sim::DomainColumn& column) {
  ReportedColumn out{.column = column.column,
                     .p_eff_kPa = column.p / kKilo,
                     .compression = reported(column.compression, column.p),
                     .extension = reported(column.extension, column.p),
                     .refusal = column.refusal};
  out.states.reserve(column.states.size());
  for (const sim::DomainState& state : column.states) out.states.push_back(reported(state));
  return out;
}

std::vector<sim::DomainColumn> domain_columns(const ReportedDomain& domain) {
  std::vector<sim::DomainColumn> columns;
  columns.reserve(domain.columns.size());
  for (const ReportedColumn& column : domain.columns) columns.push_back(in_si(column));
  return columns;
}

std::string word_of(sim::DomainStateKind kind) {
  switch (kind) {
    case sim::DomainStateKind::stable:
      return "stable";
    case sim::DomainStateKind::unstable:
      return "unstable";
    case sim::DomainStateKind::unknown:
      return "unknown";
    case sim::DomainStateKind::beyond_limit:
      return "beyond_limit";
    case sim::DomainStateKind::refused:
      break;
  }
  return "refused";
}

}  // namespace triax::study
