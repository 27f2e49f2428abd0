// SPDX-License-Identifier: GPL-3.0-or-later
// A domain as text and as CSV.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "src/domain/domain_text.hpp"
#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/study/domain/domain_counts.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kRowsOfText = 10;

std::optional<double> eta(const std::optional<study::DomainMark>& mark) {
  return mark ? std::optional(mark->eta) : std::nullopt;
}

/// Evenly spread columns, first and last among them.
std::vector<const study::ReportedColumn*> told(const study::ReportedDomain& domain) {
  const std::size_t count = domain.columns.size(), shown = std::min(count, kRowsOfText);
  std::vector<const study::ReportedColumn*> columns;
  for (std::size_t i = 0; i < shown; ++i)
    columns.push_back(&domain.columns[shown == 1 ? 0 : i * (count - 1) / (shown - 1)]);
  return columns;
}

struct Criterion {
  std::string heading;  ///< of the text
  std::string key;      ///< of the CSV
};

/// Those that were looked for: an empty cell of them says that they were not met.
std::vector<Criterion> criteria(const study::DomainSettings::Grid& grid) {
  std::vector<Criterion> all = {{"η isotropic unloading", "isotropic_unloading"}};
  for (const std::string& name : grid.criteria) all.push_back({"η " + spaced(name), name});
  all.push_back({"η plastic limit", "limit"});
  return all;
}

Table boundary_table(const study::ReportedDomain& domain,
                     study::ReportedBoundary study::ReportedColumn::*side) {
  const auto shown = criteria(domain.settings.grid);
  Table table;
  table.columns = {
      {"p′ (kPa)", Align::right}, {"η first unstable", Align::right}, {"its α (°)", Align::right}};
  for (const auto& one : shown) table.columns.push_back({one.heading, Align::right});
  for (const study::ReportedColumn* column : told(domain)) {
    const study::ReportedBoundary& b = column->*side;
    auto& row = table.rows.emplace_back();
    row = {number(column->p_eff_kPa, 1), number(eta(b.first_unstable), 4),
           number(b.first_unstable ? b.first_unstable->alpha_deg : std::nullopt, 2)};
    for (const auto& one : shown) row.push_back(number(eta(b.mark(one.key)), 4));
  }
  return table;
}

std::string shares(const study::ReportedDomain& domain) {
  const study::KindCounts of = study::counts_of_kinds(domain);
  const double all = std::max(1, std::accumulate(of.begin(), of.end(), 0));
  const auto share = [&](sim::DomainStateKind kind) {
    return 100 * of[static_cast<std::size_t>(kind)] / all;
  };
  using enum sim::DomainStateKind;
  std::string words =
      fmt::format("stable {:.1f} %, unstable {:.1f} %, ", share(stable), share(unstable));
  if (share(unknown) > 0)
    words += fmt::format("unknown {:.1f} % (no result in some directions), ", share(unknown));
  return words + fmt::format("beyond the limit {:.1f} %, out of range {:.1f} %",
                             share(beyond_limit), share(refused));
}

/// As probes call it.
std::string plane_word(const study::DomainSettings::Grid& grid) {
  return grid.plane == "plane-strain" ? "plane strain" : grid.plane;
}

std::string csv_head(const study::ReportedDomain& domain, const std::string& columns) {
  const auto& grid = domain.settings.grid;
  return fmt::format("# origin = \"simulated\"\n# {}, void ratio {}, {}, {} directions\n{}\n",
                     on_one_line(domain.settings.material.name), grid.void_ratio, plane_word(grid),
                     grid.directions, columns);
}

std::string cell(const std::optional<double>& value) {
  return value ? fmt::format(",{}", *value) : ",";
}

}  // namespace

std::string domain_text(const study::ReportedDomain& domain) {
  const auto& [material, grid, warnings] = domain.settings;
  const auto* law = sim::find_law(material.law);
  std::string out =
      simulated_head("bifurcation domain",
                     HeadOfMaterial{material.name, law != nullptr ? law->title : material.law,
                                    material.based_on, material.source, material.range});
  out +=
      fact("grid", fmt::format("p′ {:g} to {:g} kPa in {} columns, q {:g} to {:g} kPa in {} rows",
                               grid.p_from_kPa, grid.p_to_kPa, grid.columns, grid.q_from_kPa,
                               grid.q_to_kPa, grid.rows));
  out += fact("states",
              fmt::format("void ratio {:g}, no memory of a reversal; {}, {} stress directions",
                          grid.void_ratio, plane_word(grid), grid.directions));
  if (grid.q_to_kPa > 0)
    out += "\n  compression\n" +
           indented(to_text(boundary_table(domain, &study::ReportedColumn::compression)));
  if (grid.q_from_kPa < 0)
    out += "\n  extension\n" +
           indented(to_text(boundary_table(domain, &study::ReportedColumn::extension)));
  out += '\n';
  out += fact("states", shares(domain));
  for (const auto& column : domain.columns) {
    if (column.refusal.empty()) continue;
    out +=
        fact("refused", fmt::format("first at p′ {:g} kPa: {}", column.p_eff_kPa, column.refusal));
    break;
  }
  for (const auto& warning : warnings) out += fact("warning", warning);
  return without_controls(out);
}

std::string domain_states_csv(const study::ReportedDomain& domain) {
  std::size_t widest = 2;
  for (const auto& column : domain.columns)
    for (const auto& state : column.states) widest = std::max(widest, state.cones_deg.size());
  std::string columns = "p_eff_kPa,q_kPa,eta,kind,w2_normalised_least,alpha_least_deg,cones";
  for (std::size_t i = 1; i <= widest; ++i)
    columns += fmt::format(",cone_{0}_from_deg,cone_{0}_to_deg", i);
  std::string out = csv_head(domain, columns + ",refused_directions");
  for (const auto& column : domain.columns)
    for (const auto& state : column.states) {
      const bool known = state.least_work.has_value();
      out += fmt::format("{},{},{},{}", column.p_eff_kPa, state.q_kPa,
                         state.q_kPa / column.p_eff_kPa, study::word_of(state.kind));
      out += cell(state.least_work) + cell(state.least_angle_deg);
      out += known ? fmt::format(",{}", state.cones_deg.size()) : ",";
      for (std::size_t i = 0; i < widest; ++i)
        out += i < state.cones_deg.size()
                   ? fmt::format(",{},{}", state.cones_deg[i].first, state.cones_deg[i].second)
                   : ",,";
      out += fmt::format(",{}\n", state.refused_directions);
    }
  return out;
}

std::string domain_boundaries_csv(const study::ReportedDomain& domain) {
  const auto shown = criteria(domain.settings.grid);
  std::string columns = "p_eff_kPa,side,first_unstable_q_kPa,first_unstable_alpha_deg";
  for (const auto& one : shown) columns += fmt::format(",{}_q_kPa", one.key);
  std::string out = csv_head(domain, columns);
  const auto q = [](const std::optional<study::DomainMark>& mark) {
    return cell(mark ? std::optional(mark->q_kPa) : std::nullopt);
  };
  for (const auto& column : domain.columns)
    for (const bool extension : {false, true}) {
      const study::ReportedBoundary& b = extension ? column.extension : column.compression;
      out += fmt::format("{},{}", column.p_eff_kPa, extension ? "extension" : "compression");
      out += q(b.first_unstable);
      out += cell(b.first_unstable ? b.first_unstable->alpha_deg : std::nullopt);
      for (const auto& one : shown) out += q(b.mark(one.key));
      out += '\n';
    }
  return out;
}

}  // namespace triax::src
