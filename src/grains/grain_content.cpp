// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_content.hpp"

#include <fmt/format.h>

#include "lab/grains/grain_words.hpp"
#include "src/grains/grain_tables.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

std::string count(std::int64_t stored) {
  return stored == lab::kNotStored ? kUnknown : fmt::format("{}", stored);
}

std::string stiffness_words(const sim::ContactLaw& law) {
  const bool literal = law.reading == sim::StiffnessReading::literal;
  return fmt::format("kn/Ds {:g} MPa, read as kn = {} E r1 r2/(r1 + r2) ({}); kt/kn {:g}",
                     law.stiffness_over_diameter_pa / 1e6, literal ? 4 : 2,
                     spaced(lab::word(law.reading)), law.tangential_ratio);
}

std::string made_words(const lab::ReportedGrains& g) {
  if (!g.state_file.empty()) return "loaded from " + g.state_file;
  std::string words = fmt::format("from a cloud, seed {}", g.seed);
  if (g.compaction_pressure && g.compaction_friction)
    words += fmt::format(", compacted to {} kPa with a friction of {}°",
                         in_kPa(g.compaction_pressure), in_degrees(g.compaction_friction));
  if (g.porosity_wanted)
    words += fmt::format(" (found in {} trial{} for n = {:.4g})", g.trials,
                         g.trials == 1 ? "" : "s", *g.porosity_wanted);
  return words;
}

void add_specimen(std::vector<Fact>& facts, const lab::ReportedGrains& g) {
  const auto& m = g.measures;
  const auto add = [&](const char* label, std::string words) {
    facts.push_back({label, {std::move(words)}});
  };
  add("grains", fmt::format("{}, diameters {} to {} mm, median {} mm by count", g.grains,
                            in_mm(g.smallest_m), in_mm(g.largest_m), in_mm(g.median_m)));
  add("made", made_words(g));
  add("state",
      fmt::format("{}, {} and {} kPa on the walls, porosity n {}, void "
                  "ratio e {}",
                  in_kPa(m.wall_stress_pa[0]), in_kPa(m.wall_stress_pa[1]),
                  in_kPa(m.wall_stress_pa[2]), number(m.porosity, 4), number(m.void_ratio, 4)));
  add("contacts",
      fmt::format("{} of grains, {} with walls: Z {}; {} grains float, {} outside",
                  count(m.grain_contacts), count(m.wall_contacts), number(m.coordination, 3),
                  count(m.floating_grains), count(m.grains_outside)));
  add("law", stiffness_words(g.law));
  add("friction",
      fmt::format("{}° between grains, none at walls", in_degrees(g.law.friction_angle)));
  add("engine", fmt::format("density {:g} kg/m³, local damping {:g}, time step {:.4g} s",
                            g.law.density_kg_per_m3, g.law.damping, g.time_step_s));
}

std::string status_words(const db::StoredGrainRun& run) {
  const std::string sign = sign_in_words(run.status, run.sign_of_life);
  switch (run.status) {
    case db::TestStatus::running:
      return "RUNNING: stages are still being stored" + sign;
    case db::TestStatus::interrupted:
      return "INTERRUPTED: only the stages that had ended are here" + sign;
    case db::TestStatus::complete:
      break;
  }
  return {};
}

void add_section(GrainContent& content, std::string title, Table table,
                 std::vector<std::string> notes = {}, std::vector<Fact> facts = {}) {
  if (table.rows.empty()) return;
  content.sections.push_back(
      {std::move(title), std::move(table), std::move(notes), std::move(facts)});
}

void add_rose(GrainContent& content, const lab::ReportedGrainStage& stage,
              const lab::ReportedGrainRose& rose) {
  RoseTables tables = rose_tables(rose);
  std::vector<Fact> facts;
  for (auto& [label, words] : rose_facts(rose)) facts.push_back({label, {words}});
  const auto title = [&](const char* what) {
    return fmt::format("Stage {}: {}", stage.name, what);
  };
  add_section(content, title("responses and contacts"), std::move(tables.responses));
  add_section(content, title("density of second-order work (J/m³)"), std::move(tables.work), {},
              std::move(facts));
  add_section(content, title("difference of microscopic and macroscopic work (J/m³)"),
              std::move(tables.gap), gap_notes());
  add_section(content, title("energy"), std::move(tables.energy), energy_notes());
}

}  // namespace

GrainContent grain_content(const db::StoredGrainRun& run) {
  const lab::GrainReport& report = run.report;
  const std::string status = status_words(run);
  GrainContent content;
  content.title = fmt::format("Run of grains {}: {}", run.id, report.programme);
  content.banner = "SIMULATED: a discrete element model, not measured";
  if (!status.empty()) content.banner += ". " + status;
  if (!report.source.empty()) content.facts.push_back({"source", {report.source}});
  if (!status.empty()) content.facts.push_back({"status", {status}});
  if (!run.whole)
    content.facts.push_back(
        {"stored", {"by an older version: what it did not store reads " + std::string(kUnknown)}});
  if (report.specimen) add_specimen(content.facts, *report.specimen);
  add_section(content, "Stages", stages_table(report));
  add_section(content, "Paths", paths_table(report), paths_notes());
  add_section(content, "Strain paths", strain_paths_table(report), strain_paths_notes());
  add_section(content, "Marks", marks_table(report));
  add_section(content, "Rests", rests_table(report));
  for (const auto& stage : report.stages)
    if (const auto* rose = std::get_if<lab::ReportedGrainRose>(&stage.came))
      add_rose(content, stage, *rose);
  add_section(content, "Perturbations", perturbations_table(report), perturbations_notes());
  add_section(content, "Energy", energies_table(report), energy_notes());
  return content;
}

Table grain_summary_table(const std::vector<db::StoredGrainRun>& runs) {
  Table table{{{"Run", Align::right},
               {"Name"},
               {"Origin"},
               {"Status"},
               {"Grains", Align::right},
               {"n", Align::right},
               {"Z", Align::right},
               {"Stages", Align::right},
               {"Last stage"}},
              {}};
  for (const auto& run : runs) {
    const auto& [programme, source, made, stages] = run.report;
    const auto& specimen = made;  // clang 14 captures no part of a structured binding
    const auto measure = [&](double sim::GrainMeasures::*member) {
      return specimen ? std::optional(specimen->measures.*member) : std::nullopt;
    };
    table.rows.push_back(
        {fmt::format("{}", run.id), programme, "SIMULATED", std::string(to_string(run.status)),
         specimen ? fmt::format("{}", specimen->grains) : kUnknown,
         number(measure(&sim::GrainMeasures::porosity), 4),
         number(measure(&sim::GrainMeasures::coordination), 2), fmt::format("{}", stages.size()),
         stages.empty() ? kUnknown : stages.back().name + ": " + came_to(stages.back())});
  }
  return table;
}

}  // namespace triax::src
