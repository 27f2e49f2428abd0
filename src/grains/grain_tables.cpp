// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_tables.hpp"

#include <fmt/format.h>

#include "lab/grains/grain_words.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "src/grains/grain_energy_cells.hpp"
#include "src/output/words.hpp"
#include "src/study/grains/grain_path_findings.hpp"

namespace triax::src {
namespace {

Table with_columns(const std::vector<std::string>& left, const std::vector<std::string>& right) {
  Table table;
  for (const auto& heading : left) table.columns.push_back({heading, Align::left});
  for (const auto& heading : right) table.columns.push_back({heading, Align::right});
  return table;
}

std::string yes_no(bool value) { return value ? "yes" : "no"; }

/// Value and strain, or unknown.
void put_peak(const std::optional<study::GrainPeak>& peak, double unit, int decimals,
              std::vector<std::string>& row) {
  row.push_back(number(peak ? std::optional(peak->value / unit) : std::nullopt, decimals));
  row.push_back(in_percent(peak ? std::optional(peak->axial_strain) : std::nullopt, 3));
}

struct Came {
  std::string operator()(const lab::ReportedGrainPath& path) const {
    if (path.points.empty()) return spaced(lab::word(path.end));
    const auto& last = path.points.back();
    switch (path.end) {
      case sim::GrainPathEnd::axial_strain:
        return fmt::format("ε₁ = {} % reached", in_percent(last.strain.axial));
      case sim::GrainPathEnd::stress_ratio:
        return fmt::format("η = {} reached", number(last.stress_ratio(), 3));
      case sim::GrainPathEnd::at_rest:
        return fmt::format("at rest at p = {} kPa", in_kPa(last.p_pa));
      case sim::GrainPathEnd::collapse:
        return fmt::format("COLLAPSED at ε₁ = {} %", in_percent(last.strain.axial));
      default:
        return spaced(lab::word(path.end));
    }
  }
  std::string operator()(const lab::ReportedGrainRest& rest) const {
    return rest.rest.at_rest ? "at rest" : "NOT AT REST";
  }
  std::string operator()(const lab::ReportedGrainRose& rose) const {
    int at_rest = 0;
    for (const auto& probe : rose.made.rose.probes) at_rest += probe.at_rest;
    return fmt::format("{} of {} probes at rest", at_rest, rose.made.rose.probes.size());
  }
  std::string operator()(const lab::ReportedPerturbation& perturbation) const {
    return perturbation.end == sim::PerturbationEnd::collapsed ? "COLLAPSED"
                                                               : lab::word(perturbation.end);
  }
};

template <class Kind, class Row>
void for_each(const lab::GrainReport& report, const Row& row) {
  for (const auto& stage : report.stages)
    if (const auto* came = std::get_if<Kind>(&stage.came)) row(stage, *came);
}

}  // namespace

std::string came_to(const lab::ReportedGrainStage& stage) { return std::visit(Came{}, stage.came); }

Table stages_table(const lab::GrainReport& report) {
  Table table =
      with_columns({"stage", "action", "from", "result"}, {"n", "Z", "floating", "steps"});
  for (const auto& stage : report.stages)
    table.rows.push_back(
        {stage.name, spaced(stage.action), stage.from.empty() ? "as made" : stage.from,
         came_to(stage), number(stage.after.porosity, 4), number(stage.after.coordination, 2),
         fmt::format("{}", stage.after.floating_grains), fmt::format("{}", stage.steps)});
  return table;
}

Table paths_table(const lab::GrainReport& report) {
  Table table = with_columns({"stage"}, {"ε₁ (%)", "ε_v (%)", "peak q (kPa)", "at ε₁ (%)", "peak η",
                                         "at ε₁ (%)", "largest K (J)"});
  for_each<lab::ReportedGrainPath>(report, [&](const auto& stage, const auto& path) {
    const study::GrainPathFindings found = study::path_findings(path.path, path.points);
    const auto* last = path.points.empty() ? nullptr : &path.points.back();
    std::vector<std::string> row = {
        stage.name, in_percent(last ? std::optional(last->strain.axial) : std::nullopt, 3),
        in_percent(last ? std::optional(last->volumetric_strain) : std::nullopt, 3)};
    put_peak(found.q, 1e3, 2, row);
    put_peak(found.eta, 1, 3, row);
    row.push_back(in_joule(found.most_kinetic_j));
    table.rows.push_back(std::move(row));
  });
  return table;
}

std::vector<std::string> paths_notes() {
  return {
      "peaks: largest value of the points, in extension the smallest",
      fmt::format("η: only points with p above {:g} % of p at the first point", 100 * study::kMinP),
      "largest K: kinetic energy, along the path"};
}

Table strain_paths_table(const lab::GrainReport& report) {
  Table table = with_columns({"stage"}, {"R", "peak (kPa)", "at ε₁ (%)", "p (kPa)", "η", "falls",
                                         "W₂ < 0 from ε₁ (%)", "there (kPa)"});
  for_each<lab::ReportedGrainPath>(report, [&](const auto& stage, const auto& path) {
    if (path.path.kind != sim::GrainPathKind::strain_path) return;
    const study::GrainPathFindings found = study::path_findings(path.path, path.points);
    const auto* top = found.path_stress ? &path.points[found.path_stress->point] : nullptr;
    const auto* negative = found.first_negative ? &path.points[*found.first_negative] : nullptr;
    std::vector<std::string> row = {stage.name, fmt::format("{:g}", path.path.ratio)};
    put_peak(found.path_stress, 1e3, 2, row);
    row.push_back(in_kPa(top ? std::optional(top->p_pa) : std::nullopt));
    row.push_back(number(top ? std::optional(top->stress_ratio()) : std::nullopt, 3));
    row.push_back(top ? yes_no(found.path_stress->fell) : kUnknown);
    row.push_back(in_percent(negative ? std::optional(negative->strain.axial) : std::nullopt, 3));
    row.push_back(in_kPa(negative ? std::optional(negative->path_stress_pa) : std::nullopt, 2));
    table.rows.push_back(std::move(row));
  });
  return table;
}

std::vector<std::string> strain_paths_notes() {
  return {"peak, there: of σ₁ − σ₃/R",
          fmt::format("falls: afterwards by more than {:g} % of the peak", 100 * study::kFallen),
          "W₂ < 0: Eq. (30) over a twentieth of the points, first negative and for that many "
          "points more"};
}

Table marks_table(const lab::GrainReport& report) {
  Table table = with_columns({"mark", "of stage"},
                             {"ε₁ (%)", "σ₁−σ₃/R (kPa)", "q (kPa)", "p (kPa)", "η", "n", "Z"});
  for_each<lab::ReportedGrainPath>(report, [&](const auto& stage, const auto& path) {
    for (const lab::ReportedGrainMark& mark : path.marks) {
      std::vector<std::string> row = {mark.name, stage.name};
      if (mark.at)
        row.insert(row.end(), {in_percent(mark.at->strain.axial, 3),
                               in_kPa(mark.at->path_stress_pa, 2), in_kPa(mark.at->q_pa, 2),
                               in_kPa(mark.at->p_pa, 2), number(mark.at->stress_ratio(), 3),
                               number(mark.at->porosity, 4), number(mark.at->coordination, 2)});
      else
        row.insert(row.end(),
                   {"never reached", kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown});
      table.rows.push_back(std::move(row));
    }
  });
  return table;
}

Table rests_table(const lab::GrainReport& report) {
  Table table = with_columns({"stage", "from", "held", "at rest"},
                             {"steps", "unbalanced", "stress error (Pa)", "σ₁−σ₃/R (kPa)"});
  for_each<lab::ReportedGrainRest>(report, [&](const auto& stage, const auto& came) {
    const auto& settling = came.rest.settling;
    table.rows.push_back(
        {stage.name, stage.from.empty() ? "as made" : stage.from,
         came.strain_held ? "walls" : "stresses", yes_no(came.rest.at_rest),
         settling.steps == lab::kNotStored ? kUnknown : fmt::format("{}", settling.steps),
         in_joule(settling.unbalanced),
         came.strain_held ? kUnknown : number(settling.stress_error_pa, 2),
         in_kPa(came.rest.path_stress_pa, 2)});
  });
  return table;
}

Table perturbations_table(const lab::GrainReport& report) {
  Table table = with_columns({"stage", "from"}, {"step (Pa)", "energy (J)", "hit", "result",
                                                 "after (s)", "χ", "ε₁ (%)", "largest K (J)"});
  for_each<lab::ReportedPerturbation>(report, [&](const auto& stage, const auto& came) {
    const auto* last = came.points.empty() ? nullptr : &came.points.back();
    table.rows.push_back(
        {stage.name, stage.from.empty() ? "as made" : stage.from,
         fmt::format("{:.5g}", came.how.load_step_pa),
         came.how.kinetic_energy_j > 0 ? in_joule(came.how.kinetic_energy_j) : "none",
         fmt::format("{}", came.grains_hit), came_to(stage),
         number(last ? std::optional(last->time_s) : std::nullopt, 4),
         number(last ? std::optional(last->stress_share) : std::nullopt, 4),
         in_percent(last ? std::optional(last->axial_strain) : std::nullopt, 4),
         in_joule(came.most_kinetic_j)});
  });
  return table;
}

Table energies_table(const lab::GrainReport& report) {
  Table table = energy_columns("stage", Align::left);
  for (const auto& stage : report.stages) {
    if (!stage.ledger) continue;
    auto& row = table.rows.emplace_back();
    row = {stage.name};
    for (auto& cell : energy_cells(*stage.ledger)) row.push_back(std::move(cell));
  }
  return table;
}

std::vector<std::string> perturbations_notes() {
  return {"step: added to σ₁ − σ₃/R; energy: given to so many floating grains (hit)",
          "χ: σ₁ − σ₃/R over what it was at the start; ε₁ since then: both at the end",
          "largest K: kinetic energy, after the start"};
}

}  // namespace triax::src
