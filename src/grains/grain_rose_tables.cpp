// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the probes of a specimen of grains.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/grains/grain_tables.hpp"
#include "src/output/words.hpp"
#include "src/study/grains/grain_rose_findings.hpp"

namespace triax::src {
namespace {

std::string micro(double strain) { return number(1e6 * strain, 3); }

/// Decimals that show the smallest work with three digits.
int work_decimals(const sim::ProbeRose& rose) {
  double least = 1;
  for (const auto& probe : rose.probes)
    if (!probe.stopped && probe.work.lagrangian != 0)
      least = std::min(least, std::abs(probe.work.lagrangian));
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(least))), 3, 8);
}

std::string at_rest_word(const sim::GrainProbe& probe) {
  return probe.stopped ? "stopped" : probe.at_rest ? "yes" : "NO";
}

Table right_columns(const std::vector<std::string>& headings) {
  Table table;
  for (const auto& heading : headings) table.columns.push_back({heading, Align::right});
  return table;
}

void put_probe(RoseTables& tables, const sim::GrainProbe& probe, const std::string& name,
               int decimals) {
  const auto density = [decimals](double value) { return number(value, decimals); };
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
            number(probe.norm_pa > 0 ? study::micro_over_macro(probe) : std::nullopt, 3),
            number(probe.norm_pa > 0 ? study::fixed_over_macro(probe) : std::nullopt, 4)};
  }
  response.resize(tables.responses.columns.size(), kUnknown);
  response.back() = at_rest_word(probe);
  work.resize(tables.work.columns.size(), kUnknown);
}

std::string ranges_words(const std::vector<study::AngleRange>& ranges) {
  std::string words;
  for (const auto& [from, to, directions] : ranges)
    words += fmt::format("{}{}° to {}°", words.empty() ? "" : ", ", in_degrees(from, 0),
                         in_degrees(std::fmod(to, 2 * std::numbers::pi), 0));
  return words.empty() ? "in no direction" : words;
}

std::string null_words(const study::GrainRoseFindings& found, const sim::GrainProbe& null_probe) {
  if (!found.drift) return "not made";
  return fmt::format("strains by {:.2e}, {} % of the smallest probe's{}",
                     study::strain_norm(null_probe), number(100 * *found.drift, 2),
                     found.drifts() ? ": signs of W₂ are in doubt" : "");
}

}  // namespace

RoseTables rose_tables(const lab::ReportedGrainRose& rose) {
  RoseTables tables{right_columns({"α (°)", "dε₁ (10⁻⁶)", "dε₃ (10⁻⁶)", "W₂ norm.", "sliding (%)",
                                   "non-perm. (%)", "largest K (J)", "steps", "at rest"}),
                    right_columns({"α (°)", "Lagrangian", "Eulerian", "Δσ:LΔt", "div(Δu)σ:LΔt",
                                   "−σLᵗΔt:LΔt", "micro", "micro/macro", "fixed"})};
  const int decimals = work_decimals(rose.made.rose);
  for (std::size_t i = 0; i < rose.made.rose.probes.size(); ++i)
    put_probe(tables, rose.made.rose.probes[i], in_degrees(rose.made.angles[i], 0), decimals);
  put_probe(tables, rose.made.rose.null_probe, "null", decimals);
  return tables;
}

std::vector<std::pair<std::string, std::string>> rose_facts(const lab::ReportedGrainRose& rose) {
  const study::GrainRoseFindings found = study::rose_findings(rose.made.rose);
  const auto& stress = rose.made.stress;
  const double p = sim::mean_stress(stress);
  std::vector<std::pair<std::string, std::string>> facts = {
      {"state",
       fmt::format(
           "σ₁ {} kPa, σ₃ {} kPa, η {}; probes of {:g} kPa", in_kPa(stress.axial, 2),
           in_kPa(stress.radial, 2),
           number(p > 0 ? std::optional(sim::deviator_stress(stress) / p) : std::nullopt, 4),
           rose.norm_pa / 1e3)},
      {"made", fmt::format("{} of {} probes, {} at rest", found.made, rose.made.rose.probes.size(),
                           found.at_rest)},
      {"null probe", null_words(found, rose.made.rose.null_probe)}};
  if (found.made == 0) return facts;
  const auto add = [&](const char* label, std::string words) {
    facts.emplace_back(label, std::move(words));
  };
  if (!found.not_at_rest.empty()) add("NOT AT REST", ranges_words(found.not_at_rest));
  add("W₂ < 0", "Eq. (7): " + ranges_words(found.negative));
  if (found.least_normalised)
    add("least W₂",
        fmt::format("{} normalised, at {}°, of the probes at rest",
                    number(found.least_normalised, 4), in_degrees(found.least_angle, 0)));
  add("micro=macro",
      fmt::format("within {:g} %: {}", 100 * study::kAgreement, ranges_words(found.agreeing)));
  add("contacts", fmt::format("sliding or non-permanent, {:g} % more than in the null probe: {}",
                              100 * study::kIrreversible, ranges_words(found.irreversible)));
  add("motion", fmt::format("kinetic energy above {:g} times the least: {}", study::kDynamic,
                            ranges_words(found.dynamic)));
  return facts;
}

}  // namespace triax::src
