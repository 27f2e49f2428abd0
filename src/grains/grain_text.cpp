#include "src/grains/grain_text.hpp"

#include <fmt/format.h>

#include "lab/grains/grain_words.hpp"
#include "src/grains/grain_tables.hpp"
#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

std::string stiffness_words(const sim::ContactLaw& law) {
  const bool literal = law.reading == sim::StiffnessReading::literal;
  return fmt::format("kn/Ds {:g} MPa, read as kn = {} E r1 r2/(r1 + r2) ({}); kt/kn {:g}",
                     law.stiffness_over_diameter_pa / 1e6, literal ? 4 : 2,
                     spaced(lab::word(law.reading)), law.tangential_ratio);
}

std::string made_words(const study::ReportedGrains& g) {
  if (!g.state_file.empty()) return "loaded from " + g.state_file;
  std::string words = fmt::format("from a cloud, seed {}", g.seed);
  if (g.compaction_pressure && g.compaction_friction)
    words += fmt::format(", compacted to {} kPa with a friction of {}°",
                         in_kPa(g.compaction_pressure), in_degrees(g.compaction_friction));
  if (g.search)
    words += fmt::format(" (found in {} trial{} for n = {:.4g})", g.trials,
                         g.trials == 1 ? "" : "s", g.search->porosity);
  return words;
}

std::string specimen_text(const study::ReportedGrains& g) {
  const auto& m = g.measures;
  return fact("grains", fmt::format("{}, diameters {} to {} mm, median {} mm by count", g.grains,
                                    in_mm(g.smallest_m), in_mm(g.largest_m), in_mm(g.median_m))) +
         fact("made", made_words(g)) +
         fact("state", fmt::format("{}, {} and {} kPa on the walls, porosity n {}, void "
                                   "ratio e {}",
                                   in_kPa(m.wall_stress_pa[0]), in_kPa(m.wall_stress_pa[1]),
                                   in_kPa(m.wall_stress_pa[2]), number(m.porosity, 4),
                                   number(m.void_ratio, 4))) +
         fact("contacts",
              fmt::format("{} of grains, {} with walls: Z {}; {} grains float, {} outside",
                          m.grain_contacts, m.wall_contacts, number(m.coordination, 3),
                          m.floating_grains, m.grains_outside)) +
         fact("law", stiffness_words(g.law)) +
         fact("friction",
              fmt::format("{}° between grains, none at walls", in_degrees(g.law.friction_angle))) +
         fact("engine", fmt::format("density {:g} kg/m³, local damping {:g}, time step {:.4g} s",
                                    g.law.density_kg_per_m3, g.law.damping, g.time_step_s));
}

std::string section(const std::string& title, const Table& table,
                    const std::vector<std::string>& notes = {}) {
  if (table.rows.empty()) return {};
  std::string out = fmt::format("\n{}\n{}", title, indented(to_text(table)));
  for (const auto& note : notes) out += "  " + on_one_line(note) + '\n';
  return out;
}

std::string rose_text(const study::ReportedGrainStage& stage,
                      const study::ReportedGrainRose& rose) {
  const RoseTables tables = rose_tables(rose);
  const auto title = [&](const char* what) {
    return fmt::format("Stage {}: {}", stage.name, what);
  };
  std::string out = section(title("responses and contacts"), tables.responses);
  out += section(title("density of second-order work (J/m³)"), tables.work);
  if (!out.empty()) out += '\n';
  for (const auto& [label, words] : rose_facts(rose)) out += fact(label, words);
  return out;
}

}  // namespace

std::string grain_text(const study::GrainReport& report) {
  std::string out =
      simulated_head("Grains", HeadOfMaterial{report.programme, {}, {}, report.source, {}});
  if (report.specimen) out += specimen_text(*report.specimen);
  out += section("Stages", stages_table(report));
  out += section("Paths", paths_table(report), paths_notes());
  out += section("Strain paths", strain_paths_table(report), strain_paths_notes());
  out += section("Marks", marks_table(report));
  out += section("Rests", rests_table(report));
  for (const auto& stage : report.stages)
    if (const auto* rose = std::get_if<study::ReportedGrainRose>(&stage.came))
      out += rose_text(stage, *rose);
  out += section("Perturbations", perturbations_table(report), perturbations_notes());
  return without_controls(out);
}

}  // namespace triax::src
