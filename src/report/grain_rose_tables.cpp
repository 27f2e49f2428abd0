// The tables of the probes of a specimen of grains.
#include <fmt/format.h>

#include "src/report/grain_rose_findings.hpp"
#include "src/report/grain_tables.hpp"
#include "src/report/words.hpp"

namespace triax::src {
namespace {

std::string micro(double strain) { return number(1e6 * strain, 3); }
std::string in_joule(double value) { return fmt::format("{:.2e}", value); }
std::string density(double value) { return fmt::format("{:.5f}", value); }

std::string settled_word(const sim::GrainProbe& probe) {
  return probe.stopped ? "stopped" : probe.settled ? "yes" : "NO";
}

Table right_columns(const std::vector<std::string>& headings) {
  Table table;
  for (const auto& heading : headings) table.columns.push_back({heading, Align::right});
  return table;
}

void put_probe(RoseTables& tables, const sim::GrainProbe& probe, const std::string& name) {
  auto& response = tables.responses.rows.emplace_back();
  response = {name};
  auto& work = tables.work.rows.emplace_back();
  work = {name};
  if (!probe.stopped) {
    const auto& w = probe.work;
    response = {name,
                micro(probe.strain.axial),
                micro(probe.strain.radial),
                probe.norm_pa > 0 ? number(w.normalised, 3) : kUnknown,
                in_percent(probe.sliding_share),
                in_percent(w.non_permanent_share()),
                in_joule(probe.most_kinetic_j),
                fmt::format("{}", probe.steps)};
    work = {name,
            density(w.lagrangian),
            density(w.eulerian()),
            density(w.stress_part),
            density(w.volume_part),
            density(w.transport_part),
            density(w.microscopic()),
            number(probe.norm_pa > 0 ? micro_over_macro(probe) : std::nullopt, 3)};
  }
  response.resize(tables.responses.columns.size(), kUnknown);
  response.back() = settled_word(probe);
  work.resize(tables.work.columns.size(), kUnknown);
}

std::string ranges_words(const std::vector<AngleRange>& ranges, const std::string& none) {
  std::string words;
  for (const auto& [from, to, directions] : ranges)
    words += fmt::format("{}{}° to {}°", words.empty() ? "" : ", ", in_degrees(from, 0),
                         in_degrees(to, 0));
  return words.empty() ? none : words;
}

std::string null_words(const GrainRoseFindings& found, const sim::GrainProbe& null_probe) {
  if (!found.drift) return "not made";
  return fmt::format("strains by {:.2e}, {} % of the smallest probe's{}", strain_norm(null_probe),
                     number(100 * *found.drift, 2),
                     found.drifts() ? ": signs of W₂ are in doubt" : "");
}

}  // namespace

RoseTables rose_tables(const ReportedGrainRose& rose) {
  RoseTables tables{right_columns({"α (°)", "dε₁ (10⁻⁶)", "dε₃ (10⁻⁶)", "W₂ norm.", "sliding (%)",
                                   "non-perm. (%)", "K most (J)", "steps", "settled"}),
                    right_columns({"α (°)", "Lagrangian", "Eulerian", "Δσ:LΔt", "div(Δu)σ:LΔt",
                                   "−σLᵗΔt:LΔt", "micro", "micro/macro"})};
  for (std::size_t i = 0; i < rose.made.rose.probes.size(); ++i)
    put_probe(tables, rose.made.rose.probes[i], in_degrees(rose.made.angles[i], 0));
  put_probe(tables, rose.made.rose.null_probe, "null");
  return tables;
}

std::vector<std::pair<std::string, std::string>> rose_facts(const ReportedGrainRose& rose) {
  const GrainRoseFindings found = rose_findings(rose.made.rose);
  const auto& stress = rose.made.stress;
  const double p = sim::mean_stress(stress);
  std::vector<std::pair<std::string, std::string>> facts = {
      {"state",
       fmt::format(
           "σ₁ {} kPa, σ₃ {} kPa, η {}; probes of {:g} kPa", in_kPa(stress.axial, 2),
           in_kPa(stress.radial, 2),
           number(p > 0 ? std::optional(sim::deviator_stress(stress) / p) : std::nullopt, 4),
           rose.probing.norm_pa / 1e3)},
      {"made", fmt::format("{} of {} probes, {} settled", found.made, rose.made.rose.probes.size(),
                           found.settled)},
      {"null probe", null_words(found, rose.made.rose.null_probe)}};
  if (found.made == 0) return facts;
  facts.insert(
      facts.end(),
      {{"W₂ < 0", ranges_words(found.negative, "in no direction")},
       {"least W₂", fmt::format("{} normalised, at {}°", number(found.least_normalised, 4),
                                in_degrees(found.least_angle, 0))},
       {"micro=macro", fmt::format("within {:g} %: {}", 100 * kAgreement,
                                   ranges_words(found.agreeing, "in no direction"))},
       {"contacts", fmt::format("sliding and non-permanent above {:g} %: {}", 100 * kIrreversible,
                                ranges_words(found.irreversible, "in no direction"))},
       {"motion", fmt::format("kinetic energy above {:g} times the least: {}", kDynamic,
                              ranges_words(found.dynamic, "in no direction"))}});
  return facts;
}

}  // namespace triax::src
