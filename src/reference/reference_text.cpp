// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "lab/base/text.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/output/wrapping.hpp"
#include "src/reference/reference_words.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {
namespace {

using lab::ReferenceResult;

struct ReferenceColumn {
  Column column;
  std::function<std::string(const ReferenceResult&)> cell;  ///< kUnknown where it is
};

ReferenceColumn words(const char* heading, std::string ReferenceResult::*text) {
  return {{heading, Align::left}, [text](const ReferenceResult& r) { return or_unknown(r.*text); }};
}

ReferenceColumn pressure(const char* heading, std::optional<double> ReferenceResult::*pa) {
  return {{heading, Align::right}, [pa](const ReferenceResult& r) { return in_kPa(r.*pa); }};
}

ReferenceColumn percent(const char* heading, std::optional<double> ReferenceResult::*plain) {
  return {{heading, Align::right},
          [plain](const ReferenceResult& r) { return in_percent(r.*plain); }};
}

ReferenceColumn value(const char* heading, std::function<std::string(const ReferenceResult&)> f) {
  return {{heading, Align::right}, std::move(f)};
}

std::vector<ReferenceColumn> tests_columns() {
  return {
      {{"location", Align::left}, [](const auto& r) { return or_unknown(r.specimen.location); }},
      {{"sample", Align::left}, [](const auto& r) { return or_unknown(sample_of(r.specimen)); }},
      {{"specimen", Align::left},
       [](const auto& r) { return or_unknown(specimen_of(r.specimen)); }},
      words("group", &ReferenceResult::group),
      words("test", &ReferenceResult::test_type),
      words("stage", &ReferenceResult::stage),
      words("failure", &ReferenceResult::failure_mode),
      words("criterion", &ReferenceResult::failure_criterion)};
}

std::vector<ReferenceColumn> failure_columns() {
  return {pressure("σ₃ (kPa)", &ReferenceResult::cell_pressure_pa),
          pressure("u (kPa)", &ReferenceResult::pore_pressure_pa),
          pressure("q (kPa)", &ReferenceResult::q_pa),
          value("p′ (kPa)", [](const auto& r) { return in_kPa(r.p_eff_pa()); }),
          value("s′ (kPa)", [](const auto& r) { return in_kPa(r.s_eff_pa()); }),
          value("t (kPa)", [](const auto& r) { return in_kPa(r.t_pa()); }),
          percent("ε₁ (%)", &ReferenceResult::axial_strain),
          percent("ε_v (%)", &ReferenceResult::volumetric_strain),
          pressure("c_u (kPa)", &ReferenceResult::undrained_strength_pa)};
}

std::vector<ReferenceColumn> specimen_columns() {
  const auto density = [](std::optional<double> kg_m3) {
    return number(kg_m3 ? std::optional(*kg_m3 / 1e3) : kg_m3, 2);
  };
  return {value("D (mm)", [](const auto& r) { return in_mm(r.diameter_m); }),
          value("H (mm)", [](const auto& r) { return in_mm(r.height_m); }),
          percent("w₀ (%)", &ReferenceResult::initial_water_content),
          percent("w_f (%)", &ReferenceResult::final_water_content),
          value("ρ (Mg/m³)", [density](const auto& r) { return density(r.bulk_density_kg_m3); }),
          value("ρ_d (Mg/m³)", [density](const auto& r) { return density(r.dry_density_kg_m3); }),
          value("B", [](const auto& r) { return number(r.b_value, 2); }),
          pressure("p′₀ (kPa)", &ReferenceResult::consolidation_pressure_pa),
          pressure("c (kPa)", &ReferenceResult::cohesion_pa),
          value("φ (°)", [](const auto& r) { return in_degrees(r.friction_angle_rad, 1); })};
}

/// Empty if nothing of it is known.
Table known_part(const std::vector<ReferenceResult>& results,
                 const std::vector<ReferenceColumn>& columns) {
  Table table{{{"#", Align::right}}, {}};
  table.rows.resize(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) table.rows[i] = {std::to_string(i + 1)};
  for (const ReferenceColumn& one : columns) {
    std::vector<std::string> cells;
    cells.reserve(results.size());
    for (const ReferenceResult& result : results) cells.push_back(one.cell(result));
    if (std::ranges::all_of(cells, [](const auto& cell) { return cell == kUnknown; })) continue;
    table.columns.push_back(one.column);
    for (std::size_t i = 0; i < cells.size(); ++i) table.rows[i].push_back(std::move(cells[i]));
  }
  return table.columns.size() > 1 ? table : Table{};
}

std::string titled(const char* title, const Table& table, std::size_t width) {
  if (table.rows.empty()) return {};
  return fmt::format("\n{}\n{}", title, indented(to_text(table, width - 2)));
}

}  // namespace

std::string reference_text(const lab::AgsResults& file, const std::string& db, std::size_t width) {
  std::string text;
  const auto say = [&](const std::string& line) {
    text += lab::joined(wrapped(on_one_line(line), width), "\n") + '\n';
  };
  say(fmt::format("{}: {} stored as reference values in {}", file.file, what_it_is(file), db));
  if (!file.project.empty()) say("Project: " + file.project);
  text += titled("Tests", known_part(file.results, tests_columns()), width);
  text += titled("At failure", known_part(file.results, failure_columns()), width);
  text += titled("Specimens and strength", known_part(file.results, specimen_columns()), width);
  if (!file.warnings.empty()) text += '\n';
  for (const auto& warning : file.warnings) say("Note: " + study::in_words(warning));
  return text;
}

}  // namespace triax::src
