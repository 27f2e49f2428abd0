// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the probes of a specimen of grains.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/grains/grain_energy_cells.hpp"
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

/// J/m³ of three digits in the largest of the parts of a gap.
int gap_decimals(const sim::ProbeRose& rose) {
  double most = 0;
  for (const auto& probe : rose.probes)
    if (!probe.stopped && std::isfinite(probe.work.gap_left()))
      most = std::max(most, std::abs(probe.work.gap()));
  return most > 0 ? std::clamp(4 - static_cast<int>(std::floor(std::log10(most))), 3, 10) : 3;
}

void put_gap(RoseTables& tables, const sim::GrainProbe& probe, const std::string& name,
             int decimals) {
  const auto density = [decimals](double value) { return number(value, decimals); };
  auto& gap = tables.gap.rows.emplace_back();
  auto& energy = tables.energy.rows.emplace_back();
  gap = energy = {name};
  if (!probe.stopped) {
    const auto& w = probe.work;
    gap = {name,
           density(w.gap()),
           density(w.grains_turning),
           density(w.contacts_turning),
           density(w.out_of_balance),
           density(w.gap_left()),
           number(w.boundary_part, 4)};
    for (auto& cell : energy_cells(probe.ledger)) energy.push_back(std::move(cell));
  }
  gap.resize(tables.gap.columns.size(), kUnknown);
  energy.resize(tables.energy.columns.size(), kUnknown);
}

void put_probe(RoseTables& tables, const sim::GrainProbe& probe, const std::string& name,
               int decimals, bool by_stress) {
  const auto density = [decimals](double value) { return number(value, decimals); };
  auto& response = tables.responses.rows.emplace_back();
  response = {name};
  auto& work = tables.work.rows.emplace_back();
  work = {name};
  if (!probe.stopped) {
    const auto& w = probe.work;
    response = {name,
                by_stress ? micro(probe.strain.axial) : number(probe.stress.axial, 2),
                by_stress ? micro(probe.strain.radial) : number(probe.stress.radial, 2),
                probe.null() ? kUnknown : number(w.normalised, 3),
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
            number(probe.null() ? std::nullopt : study::micro_over_macro(probe), 3),
            number(probe.null() ? std::nullopt : study::fixed_over_macro(probe), 4)};
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

std::vector<std::string> gap_notes() {
  return {
      "micro − macro: Σ over contacts (11) minus (7), the sum of the next three columns and left",
      "grains, contacts: their rotation under the forces they carry; balance: unbalanced forces",
      "boundary: the term of Eq. (22), 0 if walls move steadily; not part of the sum"};
}

std::vector<std::string> energy_notes() {
  return {
      "walls = elastic + kinetic + friction + damping + stopped + error, from the first step on",
      "error: as a fraction of the largest of input, output and content",
      "momentum: the largest component that is missing, kg m/s"};
}

RoseTables rose_tables(const lab::ReportedGrainRose& rose) {
  const bool by_stress = rose.kind == sim::ProbeKind::stress;
  RoseTables tables{right_columns({"α (°)", by_stress ? "dε₁ (10⁻⁶)" : "dσ₁ (Pa)",
                                   by_stress ? "dε₃ (10⁻⁶)" : "dσ₃ (Pa)", "W₂ norm.", "sliding (%)",
                                   "non-perm. (%)", "largest K (J)", "steps", "at rest"}),
                    right_columns({"α (°)", "Lagrangian", "Eulerian", "Δσ:LΔt", "div(Δu)σ:LΔt",
                                   "−σLᵗΔt:LΔt", "micro", "micro/macro", "fixed"}),
                    right_columns({"α (°)", "micro − macro", "grains", "contacts", "balance",
                                   "left", "boundary"}),
                    energy_columns("α (°)", Align::right)};
  const sim::ProbeRose& made = rose.made.rose;
  const bool ledgers = std::isfinite(made.null_probe.ledger.walls_j);  // of older versions: none
  const int decimals = work_decimals(made), finer = gap_decimals(made);
  for (std::size_t i = 0; i < made.probes.size(); ++i) {
    const std::string name = in_degrees(rose.made.angles[i], 0);
    put_probe(tables, made.probes[i], name, decimals, by_stress);
    if (ledgers) put_gap(tables, made.probes[i], name, finer);
  }
  put_probe(tables, made.null_probe, "null", decimals, by_stress);
  if (ledgers) put_gap(tables, made.null_probe, "null", finer);
  return tables;
}

std::vector<std::pair<std::string, std::string>> rose_facts(const lab::ReportedGrainRose& rose) {
  const study::GrainRoseFindings found = study::rose_findings(rose.made.rose);
  const auto& stress = rose.made.stress;
  const double p = sim::mean_stress(stress);
  std::vector<std::pair<std::string, std::string>> facts = {
      {"state",
       fmt::format(
           "σ₁ {} kPa, σ₃ {} kPa, η {}; probes of {}", in_kPa(stress.axial, 2),
           in_kPa(stress.radial, 2),
           number(p > 0 ? std::optional(sim::deviator_stress(stress) / p) : std::nullopt, 4),
           rose.kind == sim::ProbeKind::stress ? fmt::format("{:g} kPa", rose.norm_pa / 1e3)
                                               : fmt::format("{:g} of strain", rose.norm_strain))},
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
  if (found.gap_left)
    add("micro−macro",
        fmt::format("{} % of the difference is the rotation of grains; fraction left {:.1e}",
                    number(100 * *found.gap_of_grains, 1), *found.gap_left));
  if (found.max_boundary_term)
    add("boundary", fmt::format("the term of Eq. (22) is at most {} J/m³",
                                number(*found.max_boundary_term, 4)));
  if (found.max_energy_error)
    add("energy",
        fmt::format("largest error of the energy balances {:.1e}", *found.max_energy_error));
  add("contacts", fmt::format("sliding or non-permanent, {:g} % more than in the null probe: {}",
                              100 * study::kIrreversible, ranges_words(found.irreversible)));
  add("motion", fmt::format("kinetic energy above {:g} times the least: {}", study::kDynamic,
                            ranges_words(found.dynamic)));
  return facts;
}

}  // namespace triax::src
