// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_text.hpp"

#include <fmt/format.h>

#include "src/grains/grain_content.hpp"
#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"

namespace triax::src {
namespace {

std::string facts_text(const std::vector<Fact>& facts) {
  std::string out;
  for (const auto& [label, lines] : facts)
    for (const auto& line : lines) out += fact(label, line);
  return out;
}

std::string section_text(const GrainSection& section) {
  std::string out = fmt::format("\n{}\n{}", section.title, indented(to_text(section.table)));
  for (const auto& note : section.notes) out += "  " + on_one_line(note) + '\n';
  if (!section.facts.empty()) out += '\n' + facts_text(section.facts);
  return out;
}

}  // namespace

std::string grain_text(const db::StoredGrainRun& run) {
  const GrainContent content = grain_content(run);
  std::string out = simulated_head("Grains", HeadOfMaterial{run.report.programme, {}, {}, {}, {}}) +
                    facts_text(content.facts);
  for (const auto& section : content.sections) out += section_text(section);
  return without_controls(out);
}

std::string grain_runs_text(const std::vector<db::StoredGrainRun>& runs) {
  std::string out = "Runs of grains\n" + indented(to_text(grain_summary_table(runs)));
  for (const auto& run : runs) out += '\n' + grain_text(run);
  return without_controls(out);
}

}  // namespace triax::src
