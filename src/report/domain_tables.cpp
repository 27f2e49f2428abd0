// A domain as text and as CSV.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/output/table.hpp"
#include "src/report/domain_report.hpp"
#include "src/report/words.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kRowsOfText = 10;

std::optional<double> eta(const std::optional<DomainMark>& mark) {
  return mark ? std::optional(mark->eta) : std::nullopt;
}

/// Evenly spread columns, first and last among them.
std::vector<const ReportedColumn*> told(const ReportedDomain& domain) {
  const std::size_t count = domain.columns.size(), shown = std::min(count, kRowsOfText);
  std::vector<const ReportedColumn*> columns;
  for (std::size_t i = 0; i < shown; ++i)
    columns.push_back(&domain.columns[shown == 1 ? 0 : i * (count - 1) / (shown - 1)]);
  return columns;
}

Table boundary_table(const ReportedDomain& domain, ReportedBoundary ReportedColumn::*side) {
  using Mark = std::optional<DomainMark> ReportedBoundary::*;
  std::vector<std::pair<const char*, Mark>> criteria = {
      {"η isotropic unloading", &ReportedBoundary::isotropic_unloading},
      {"η determinant", &ReportedBoundary::determinant},
      {"η localisation", &ReportedBoundary::localisation},
      {"η plastic limit", &ReportedBoundary::limit}};
  if (!domain.settings.grid.localisation) criteria.erase(criteria.begin() + 2);
  Table table;
  table.columns = {
      {"p′ (kPa)", Align::right}, {"η first unstable", Align::right}, {"its α (°)", Align::right}};
  for (const auto& [heading, mark] : criteria) table.columns.push_back({heading, Align::right});
  for (const ReportedColumn* column : told(domain)) {
    const ReportedBoundary& b = column->*side;
    auto& row = table.rows.emplace_back();
    row = {number(column->p_eff_kPa, 1), number(eta(b.first_unstable), 4),
           number(b.first_unstable ? b.first_unstable->alpha_deg : std::nullopt, 2)};
    for (const auto& [heading, mark] : criteria) row.push_back(number(eta(b.*mark), 4));
  }
  return table;
}

std::array<int, 4> counts(const ReportedDomain& domain) {
  std::array<int, 4> all{};
  for (const auto& column : domain.columns)
    for (const auto& state : column.states) ++all[static_cast<std::size_t>(state.kind)];
  return all;
}

std::string shares(const ReportedDomain& domain) {
  const auto of = counts(domain);
  const double all = std::max(1, of[0] + of[1] + of[2] + of[3]);
  return fmt::format(
      "stable {:.1f} %, unstable {:.1f} %, beyond the limit {:.1f} %, refused {:.1f} %",
      100 * of[0] / all, 100 * of[1] / all, 100 * of[2] / all, 100 * of[3] / all);
}

std::string csv_head(const ReportedDomain& domain, const std::string& columns) {
  const auto& grid = domain.settings.grid;
  return fmt::format("# origin = \"simulated\"\n# {}, void ratio {}, {}, {} directions\n{}\n",
                     on_one_line(domain.settings.material.name), grid.void_ratio, grid.plane,
                     grid.directions, columns);
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format(",{}", *value) : ",";
}

}  // namespace

std::string domain_text(const ReportedDomain& domain) {
  const auto& [material, grid, warnings] = domain.settings;
  const std::string title =
      on_one_line(fmt::format("bifurcation domain of {} (simulated)", material.name));
  std::string out = title + '\n' + std::string(display_width(title), '=') + '\n';
  const auto fact = [&out](const char* label, const std::string& value) {
    if (!value.empty()) out += fmt::format("  {:<12}{}\n", label, on_one_line(value));
  };
  fact("based on", material.based_on);
  fact("source", material.source);
  fact("range", material.range);
  fact("grid", fmt::format("p′ {:g} to {:g} kPa in {} columns, q {:g} to {:g} kPa in {} rows",
                           grid.p_from_kPa, grid.p_to_kPa, grid.columns, grid.q_from_kPa,
                           grid.q_to_kPa, grid.rows));
  fact("states", fmt::format("void ratio {:g}, no memory of a reversal; {}, {} stress directions",
                             grid.void_ratio, grid.plane, grid.directions));
  if (grid.q_to_kPa > 0)
    out += "\n  compression\n" +
           indented(to_text(boundary_table(domain, &ReportedColumn::compression)));
  if (grid.q_from_kPa < 0)
    out +=
        "\n  extension\n" + indented(to_text(boundary_table(domain, &ReportedColumn::extension)));
  out += '\n';
  fact("states", shares(domain));
  for (const auto& column : domain.columns) {
    if (column.refusal.empty()) continue;
    fact("refused", fmt::format("at p′ {:g} kPa first: {}", column.p_eff_kPa, column.refusal));
    break;
  }
  for (const auto& warning : warnings) fact("warning", warning);
  return without_controls(out);
}

std::string domain_states_csv(const ReportedDomain& domain) {
  std::string out =
      csv_head(domain,
               "p_eff_kPa,q_kPa,eta,kind,w2_normalised_least,alpha_least_deg,cones,cone_1_from_deg,"
               "cone_1_to_deg,cone_2_from_deg,cone_2_to_deg,refused_directions");
  for (const auto& column : domain.columns)
    for (const auto& state : column.states) {
      const bool known = state.least_work.has_value();
      out += fmt::format("{},{},{},{}", column.p_eff_kPa, state.q_kPa,
                         state.q_kPa / column.p_eff_kPa, word_of(state.kind));
      out += cell(state.least_work) + cell(state.least_angle_deg);
      out += known ? fmt::format(",{}", state.cones_deg.size()) : ",";
      for (std::size_t i = 0; i < 2; ++i)
        out += i < state.cones_deg.size()
                   ? fmt::format(",{},{}", state.cones_deg[i].first, state.cones_deg[i].second)
                   : ",,";
      out += fmt::format(",{}\n", state.refused_directions);
    }
  return out;
}

std::string domain_boundaries_csv(const ReportedDomain& domain) {
  std::string out = csv_head(
      domain,
      "p_eff_kPa,side,first_unstable_q_kPa,first_unstable_alpha_deg,isotropic_unloading_q_kPa,"
      "determinant_q_kPa,localisation_q_kPa,limit_q_kPa");
  const auto q = [](const std::optional<DomainMark>& mark) {
    return cell(mark ? std::optional(mark->q_kPa) : std::nullopt);
  };
  for (const auto& column : domain.columns)
    for (const bool extension : {false, true}) {
      const ReportedBoundary& b = extension ? column.extension : column.compression;
      out += fmt::format("{},{}", column.p_eff_kPa, extension ? "extension" : "compression");
      out += q(b.first_unstable);
      out += cell(b.first_unstable ? b.first_unstable->alpha_deg : std::nullopt);
      out += q(b.isotropic_unloading) + q(b.determinant) + q(b.localisation) + q(b.limit) + '\n';
    }
  return out;
}

}  // namespace triax::src
