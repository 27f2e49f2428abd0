// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/total_stress_sheet.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/output/words.hpp"
#include "src/study/sheet/specimen_phases.hpp"
#include "src/study/sheet/total_stress.hpp"
#include "src/triaxial/sheet/set_figure.hpp"
#include "src/triaxial/sheet/sheet_figures.hpp"

namespace triax::src {
namespace {

using Value = std::optional<double>;

/// Blank where it is not known.
Fact known_fact(const char* label, const Value& value, int decimals) {
  return fact_or_blank(label, number(value, decimals));
}

std::string known_cell(const Value& value, int decimals) {
  return value ? number(value, decimals) : std::string();
}

Value scaled(const Value& value, double factor) {
  return value ? Value(*value * factor) : std::nullopt;
}

Value kilopascals(double pa) { return scaled(if_known(pa), 1e-3); }

/// Total: the larger one is σ₁.
struct TotalStresses {
  Value major_kPa, minor_kPa;
};
TotalStresses total_stresses(const study::ScanValues& at) {
  const Value cell = kilopascals(at.cell_pressure), q = kilopascals(at.state.q);
  if (!cell || !q) return {};
  return {std::max(*cell, *cell + *q), std::min(*cell, *cell + *q)};
}

Value strength_kPa(const SheetTest& test) {
  return scaled(study::undrained_strength(test.values.failure), 1e-3);
}

Value percent_per_minute(const SheetTest& test) { return scaled(test.values.rate_per_s, 100 * 60); }

study::SpecimenPhases specimen_phases_of(const SheetTest& test) {
  return study::specimen_phases(test.result.stored, test.values, test.words);
}

std::optional<DrawnCircle> total_circle(const SheetTest& test, const std::string& name) {
  if (!test.values.failure) return std::nullopt;
  const auto [major, minor] = total_stresses(*test.values.failure);
  if (!major || !(*major > *minor)) return std::nullopt;
  return DrawnCircle{name, *minor, *major};
}

SheetPart total_circles_part(const std::vector<DrawnCircle>& circles, const Value& mean_kPa,
                             int width) {
  std::optional<DrawnEnvelope> envelope;
  if (mean_kPa)
    envelope = {.cohesion_kPa = *mean_kPa,
                .friction_angle_deg = 0,
                .name = fmt::format("c_u = {:.1f} kPa", *mean_kPa)};
  return mohr_part(circles, envelope, width, "σ (kPa)");
}

SheetBox total_stress_specimens_box(const std::vector<const SheetTest*>& tests) {
  SheetBox box{
      .title = "Specimens; failure at the largest q up to ε₁ = 20 %; c_u = q_f/2; stresses in kPa"};
  if (tests.front()->values.options.failure == study::FailureCriterion::axial_strain)
    box.title = fmt::format("Specimens; failure at ε₁ = {:.4g} %; c_u = q_f/2; stresses in kPa",
                            tests.front()->values.options.failure_strain * 100);
  box.table.columns = {{"test"}, {"type"}};
  for (const char* heading :
       {"ρ (Mg/m³)", "ρ_d (Mg/m³)", "w (%)", "%/min", "ε_f (%)", "σ₃", "σ₁", "q_f", "c_u"})
    box.table.columns.push_back({heading, Align::right});
  box.table.columns.push_back({"mode of failure"});
  for (const auto* test : tests) {
    const auto built = specimen_phases_of(*test).built;
    const auto& failure = test->values.failure;
    const auto stresses = failure ? total_stresses(*failure) : TotalStresses{};
    box.table.rows.push_back(
        {test->result.stored.header.name, test->result.stored.header.programme,
         known_cell(scaled(built.bulk_density, 1e-3), 3),
         known_cell(scaled(built.dry_density, 1e-3), 3),
         known_cell(scaled(built.water_content, 100), 1), known_cell(percent_per_minute(*test), 2),
         failure ? known_cell(scaled(if_known(failure->state.strain.axial), 100), 2)
                 : std::string(),
         known_cell(stresses.minor_kPa, 1), known_cell(stresses.major_kPa, 1),
         failure ? known_cell(kilopascals(failure->state.q), 1) : std::string(),
         known_cell(strength_kPa(*test), 1), study::word_of(test->words, "failure_mode")});
  }
  return box;
}

SheetBox mean_box(const std::vector<double>& strengths_kPa, std::size_t specimens) {
  SheetBox box{.title = "Undrained strength of the set"};
  if (strengths_kPa.empty()) {
    box.lines.emplace_back("none: no specimen failed");
    return box;
  }
  const auto mean = study::mean_strength(strengths_kPa);
  box.facts = {known_fact("mean c_u (kPa)", mean.mean, 1),
               {"least, largest (kPa)", {fmt::format("{:.1f}, {:.1f}", mean.least, mean.largest)}},
               known_fact("standard deviation (kPa)", mean.standard_deviation, 1)};
  box.lines.push_back(fmt::format(
      "c_u = q_f/2, mean of {} of {} specimens; the line is τ = c_u, φ_u = 0, which holds for "
      "saturated soil only",
      strengths_kPa.size(), specimens));
  return box;
}

}  // namespace

SheetBox total_stress_specimen_box(const SheetTest& test) {
  const auto phases = specimen_phases_of(test);
  SheetBox box{.title = "Specimen",
               .table = {{{""}, {"as built", Align::right}, {"after", Align::right}}, {}}};
  const auto row = [&](const char* label, const Value& built, const Value& end, double factor,
                       int decimals) {
    box.table.rows.push_back({label, known_cell(scaled(built, factor), decimals),
                              known_cell(scaled(end, factor), decimals)});
  };
  const auto &a = phases.built, &b = phases.end;
  row("H (mm)", a.height_m, b.height_m, 1e3, 2);
  row("D (mm)", a.diameter_m, b.diameter_m, 1e3, 2);
  row("m (g)", a.mass_kg, b.mass_kg, 1e3, 1);
  row("w (%)", a.water_content, b.water_content, 100, 1);
  row("ρ (Mg/m³)", a.bulk_density, b.bulk_density, 1e-3, 3);
  row("ρ_d (Mg/m³)", a.dry_density, b.dry_density, 1e-3, 3);
  row("e", a.void_ratio, b.void_ratio, 1, 3);
  row("S_r (%)", a.saturation, b.saturation, 100, 0);
  const auto& gs = test.result.stored.header.specimen.specific_gravity;
  box.lines.push_back(gs ? fmt::format("G_s = {:.3g}", *gs) : "G_s: not given");
  return box;
}

SheetBox total_stress_test_box(const SheetTest& test) {
  SheetBox box{.title = "Test"};
  const auto& values = test.values;
  box.facts.push_back(
      known_fact("σ₃ (kPa)", values.start ? kilopascals(values.start->cell_pressure) : Value(), 1));
  box.facts.push_back(known_fact("rate of ε₁ up to failure (%/min)", percent_per_minute(test), 3));
  const auto& height = test.result.stored.header.specimen.height_m;
  box.facts.push_back(known_fact(
      "rate (mm/min)",
      values.rate_per_s && height ? Value(*values.rate_per_s * *height * 1e3 * 60) : std::nullopt,
      3));
  Value minutes;
  if (values.failure && values.start)
    minutes = scaled(if_known(values.failure->state.time_s - values.start->state.time_s), 1.0 / 60);
  box.facts.push_back(known_fact("time to failure (min)", minutes, 1));
  box.facts.push_back(
      known_fact("ε₁ at the end (%)",
                 values.end ? scaled(if_known(values.end->state.strain.axial), 100) : Value(), 2));
  box.lines.emplace_back("total stresses: neither saturation nor consolidation, u is not used");
  return box;
}

SheetBox total_stress_failure_box(const SheetTest& test) {
  const auto& values = test.values;
  const bool strain = values.options.failure == study::FailureCriterion::axial_strain;
  SheetBox box{
      .title = strain ? fmt::format("Failure at ε₁ = {:.4g} %", values.options.failure_strain * 100)
                      : "Failure at the largest q up to ε₁ = 20 %",
      .columns = 2};
  if (!values.failure) {
    box.lines.push_back("none: " + values.failure_reason);
    return box;
  }
  const auto& s = values.failure->state;
  const auto stresses = total_stresses(*values.failure);
  box.facts = {known_fact("c_u = q_f/2 (kPa)", strength_kPa(test), 1),
               known_fact("q_f (kPa)", kilopascals(s.q), 1),
               known_fact("ε_f (%)", scaled(if_known(s.strain.axial), 100), 2),
               known_fact("A (mm²)", scaled(if_known(s.area_m2), 1e6), 1),
               known_fact("σ₁ (kPa)", stresses.major_kPa, 1),
               known_fact("σ₃ (kPa)", stresses.minor_kPa, 1),
               {"reading", {fmt::format("{}", s.reading)}}};
  if (!values.failure_reason.empty()) box.lines.push_back(values.failure_reason);
  return box;
}

std::vector<SheetRow> total_stress_rows(const SheetTest& test) {
  std::vector<SheetRow> rows;
  rows.push_back(row_of_boxes({{1.1, total_stress_specimen_box(test)},
                               {1, total_stress_test_box(test)},
                               {1.3, total_stress_failure_box(test)}}));
  SheetRow figures;
  if (auto plot = set_figure({&test}, axial_strain_axis(), q_axis()))
    figures.parts.push_back({.plot = std::move(plot)});
  if (const auto circle = total_circle(test, ""))
    figures.parts.push_back(total_circles_part({*circle}, strength_kPa(test), kSheetFigureWidth));
  if (!figures.parts.empty()) rows.push_back(std::move(figures));
  return rows;
}

std::vector<SheetRow> total_stress_set_rows(const std::vector<const SheetTest*>& tests) {
  constexpr std::size_t kMostNames = 12;
  std::vector<DrawnCircle> circles;
  std::vector<double> strengths;
  for (const auto* test : tests) {
    if (const auto c = strength_kPa(*test)) strengths.push_back(*c);
    const auto name = tests.size() <= kMostNames ? test->result.stored.header.name : "";
    if (const auto circle = total_circle(*test, name)) circles.push_back(*circle);
  }
  std::vector<SheetRow> rows;
  if (tests.size() <= kMostCurves) {
    rows.emplace_back();
    rows.back().parts.push_back({.box = total_stress_specimens_box(tests)});
  }
  rows.emplace_back();
  if (!circles.empty()) {
    rows.back().parts.push_back(total_circles_part(
        circles, strengths.empty() ? Value() : Value(study::mean_strength(strengths).mean),
        2 * kSheetFigureWidth));
    rows.back().parts.back().share = 2;
  }
  rows.back().parts.push_back({.box = mean_box(strengths, tests.size())});
  rows.emplace_back();
  if (auto plot = set_figure(tests, axial_strain_axis(), q_axis()))
    rows.back().parts.push_back({.plot = std::move(plot)});
  else
    rows.pop_back();
  return rows;
}

}  // namespace triax::src
