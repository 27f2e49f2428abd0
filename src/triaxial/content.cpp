// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/content.hpp"

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "src/output/words.hpp"
#include "src/triaxial/facts/collapse_fact.hpp"
#include "src/triaxial/facts/undrained_strength_fact.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"

namespace triax::src {
namespace {

using lab::Origin;

std::string origin_word(const db::StoredTest& test) {
  return test.header.origin == Origin::simulated ? "SIMULATED" : "recorded";
}

std::string kind_word(const db::StoredTest& test) {
  return verdict_word(test.status, study::has_verdict(test)
                                       ? std::optional(test.summary.collapse.kind)
                                       : std::nullopt);
}

std::string agreement(const db::StoredTest& test) {
  if (!study::has_verdict(test)) return kUnknown;
  return fmt::format("{} of {}", study::agreeing_criteria(test).size(),
                     test.summary.collapse.criteria.size());
}

std::string banner(const db::StoredTest& test) {
  std::vector<std::string> parts;
  if (test.header.origin == Origin::simulated) parts.emplace_back("SIMULATED, not measured");
  const std::string sign = sign_in_words(test.status, test.sign_of_life);
  if (test.status == db::TestStatus::interrupted)
    parts.push_back(fmt::format("INTERRUPTED: the test was cut off{}; not assessed", sign));
  if (test.status == db::TestStatus::running)
    parts.push_back(
        fmt::format("RUNNING: the test is still being recorded{}; not assessed yet", sign));
  return fmt::format("{}", fmt::join(parts, ". "));
}

std::string origin_line(const db::StoredTest& test) {
  const auto& header = test.header;
  std::string line = header.origin == Origin::simulated ? "simulated" : "recorded";
  if (!header.source.empty()) line += " in " + header.source;
  if (!header.dialect.empty()) line += fmt::format(" (read as {})", header.dialect);
  if (header.seed) line += fmt::format(", seed {}", *header.seed);
  return line;
}

std::string sweep_line(const db::SweepMembership& sweep) {
  std::string line = fmt::format("number {} of the sweep {}: ", sweep.place, sweep.sweep);
  for (const auto& [key, value] : sweep.values)
    line += fmt::format("{}{} = {}", line.ends_with(' ') ? "" : ", ", key, value);
  return line;
}

std::string specimen_line(const lab::SpecimenInfo& specimen) {
  std::vector<std::string> parts;
  if (!specimen.material.empty()) parts.push_back(specimen.material);
  if (specimen.height_m) parts.push_back(fmt::format("height {} mm", in_mm(specimen.height_m)));
  if (specimen.diameter_m)
    parts.push_back(fmt::format("diameter {} mm", in_mm(specimen.diameter_m)));
  if (specimen.void_ratio)
    parts.push_back(fmt::format("void ratio as built {}", number(specimen.void_ratio, 3)));
  return parts.empty() ? kUnknown : fmt::format("{}", fmt::join(parts, ", "));
}

std::string shear_start_line(const db::StoredTest& test) {
  const auto& at = test.summary.consolidation;
  std::vector<std::string> parts;
  if (at.p_eff_pa) parts.push_back(fmt::format("p′₀ {} kPa", in_kPa(at.p_eff_pa)));
  if (study::void_ratio(test))
    parts.push_back(fmt::format("e₀ {}", number(study::void_ratio(test), 3)));
  if (at.height_m) parts.push_back(fmt::format("height {} mm", in_mm(at.height_m)));
  if (at.diameter_m) parts.push_back(fmt::format("diameter {} mm", in_mm(at.diameter_m)));
  if (at.b_value) parts.push_back(fmt::format("B value {}", number(at.b_value, 3)));
  return parts.empty() ? kUnknown : fmt::format("{}", fmt::join(parts, ", "));
}

std::string axis_line(const db::StoredTest& test) {
  const auto count = fmt::format("{} readings", test.summary.readings);
  return test.header.has_time ? count + ", rates along time"
                              : count + ", no time in the record: rates along the axial strain";
}

void add_tags(std::vector<Fact>& facts, const db::StoredTest& test) {
  if (!test.tags.empty())
    facts.push_back({"Tags", {fmt::format("{}", fmt::join(test.tags, ", "))}});
}

std::string stored_line(const db::StoredTest& test) {
  return fmt::format("{}, {}", test.stored_at, status_in_words(test.status, test.sign_of_life));
}

std::vector<std::string> note_lines(const std::vector<lab::Note>& notes) {
  std::string line;
  for (const auto& note : notes) {
    if (!line.empty()) line += "; ";
    line += note.label.empty() ? note.text : note.label + ": " + note.text;
  }
  return line.empty() ? std::vector<std::string>{} : std::vector<std::string>{line};
}

std::vector<std::string> guess_lines(const std::vector<lab::Guess>& guesses) {
  std::vector<std::string> lines;
  lines.reserve(guesses.size());
  for (const auto& guess : guesses)
    lines.push_back(fmt::format("{} assumed to be {}: {}; otherwise {}", guess.what, guess.taken,
                                guess.evidence, guess.remedy));
  return lines;
}

std::string membrane_line(const db::StoredTest& test) {
  const auto& applied = test.summary.membrane_correction;
  const auto& specimen = test.header.specimen;
  if (applied.empty()) return "unknown: the record was already reduced";
  if (applied == "none") return "none";
  return fmt::format("{}, thickness {} mm, modulus {} kPa",
                     applied == "astm" ? "ASTM D4767" : "ISO 17892-9",
                     in_mm(specimen.membrane_thickness_m), in_kPa(specimen.membrane_modulus_pa, 0));
}

std::string detected_word(const lab::Criterion& criterion) {
  if (!criterion.detected) return "not assessed";
  return *criterion.detected ? "yes" : "no";
}

Table criteria_table(const db::StoredTest& test) {
  Table table{{{"Criterion"},
               {"Detected"},
               {"Reading", Align::right},
               {"Time", Align::right},
               {"η", Align::right},
               {"Detected at", Align::right},
               {"Evidence"}},
              {}};
  for (const auto& criterion : test.summary.collapse.criteria)
    table.rows.push_back(
        {spaced(criterion.name), detected_word(criterion),
         criterion.reading ? fmt::format("{}", *criterion.reading) : kUnknown,
         duration(criterion.time_s), number(criterion.eta, 2),
         criterion.detected_at ? fmt::format("{}", criterion.detected_at->reading) : kUnknown,
         criterion.evidence});
  return table;
}

/// Beginnings of stages are no news in a report.
Table events_table(const db::StoredTest& test) {
  Table table{{{"Event"},
               {"Reading", Align::right},
               {"Time", Align::right},
               {"Detected at", Align::right},
               {"at time", Align::right},
               {"What"}},
              {}};
  for (const lab::Event& event : test.events) {
    if (event.kind == lab::EventKind::stage_started) continue;
    const auto& detected_at = event.detected_at;
    table.rows.push_back(
        {spaced(std::string(to_string(event.kind))), fmt::format("{}", event.reading),
         duration(event.time_s), detected_at ? fmt::format("{}", detected_at->reading) : kUnknown,
         duration(detected_at ? detected_at->time_s : std::nullopt), event.detail});
  }
  return table;
}

Table checks_table(const db::StoredTest& test) {
  Table table{{{"Check"}, {"Measured", Align::right}, {"Limit", Align::right}, {"Result"}, {"Why"}},
              {}};
  const auto plain = [](std::optional<double> value) {
    return value ? fmt::format("{:.4g}", *value) : std::string(kUnknown);
  };
  for (const auto& check : test.summary.checks)
    table.rows.push_back({spaced(std::string(to_string(check.kind))), plain(check.measured),
                          plain(check.limit), check.ok ? "ok" : "NOT OK", check.note});
  return table;
}

/// "2, 2026-11-27T10:00:00Z: specimen.height_mm 140 -> 150; before: flow, η = 0.740"
std::string revision_line(const db::Revision& revision) {
  const auto shown = [](const std::string& text) { return text.empty() ? "unknown" : text; };
  std::vector<std::string> values;
  for (const db::RevisedValue& value : revision.values)
    values.push_back(
        fmt::format("{} {} -> {}", value.key, shown(value.before), shown(value.after)));
  std::string line = fmt::format(
      "{}, {}: {}; before: {}", revision.number, revision.revised_at, lab::joined(values),
      revision.former_kind ? to_string(*revision.former_kind) : "not assessed");
  if (revision.former_eta) line += fmt::format(", η = {:.3f}", *revision.former_eta);
  return line;
}

void add_revisions(std::vector<Fact>& facts, const db::StoredTest& test) {
  if (test.revisions.empty()) return;
  facts.push_back({"Revisions", {}});
  for (const db::Revision& revision : test.revisions)
    facts.back().lines.push_back(revision_line(revision));
}

/// What every account of a test begins with.
TestContent begun_content(const db::StoredTest& test) {
  TestContent content;
  content.title = fmt::format("Test {}: {}", test.id, test.header.name);
  content.banner = banner(test);
  auto& facts = content.facts;
  facts.push_back({"Type of test", {or_unknown(test.header.programme)}});
  facts.push_back({"Data", {origin_line(test), axis_line(test)}});
  if (test.sweep) facts.back().lines.push_back(sweep_line(*test.sweep));
  return content;
}

}  // namespace

Table summary_table(const std::vector<study::TestResult>& tests) {
  Table table{{{"Type of test"},
               {"Test"},
               {"Origin"},
               {"p′₀ (kPa)", Align::right},
               {"e₀", Align::right},
               {"φ_mob (°)", Align::right},
               {"η_coll", Align::right},
               {"Collapse"},
               {"Limit surface"},
               {"Criteria"}},
              {}};
  for (const auto& [test, curves] : tests) {
    const auto onset = study::collapse_onset(test);
    table.rows.push_back({or_unknown(test.header.programme), test.header.name, origin_word(test),
                          in_kPa(test.summary.consolidation.p_eff_pa, 0),
                          number(study::void_ratio(test), 3),
                          in_degrees(onset ? onset->phi_mob_rad() : std::nullopt),
                          number(onset ? onset->eta() : std::nullopt, 2), kind_word(test),
                          inside_limit_surface(test.summary.collapse), agreement(test)});
  }
  return table;
}

std::vector<std::string> summary_notes() {
  return {
      "p′₀, e₀: mean effective stress and void ratio at the start of shear",
      "η_coll = q/p′ at the onset of instability; φ_mob from sin φ_mob = 3η/(6 + η)",
      "Limit surface: whether the onset lies inside the Mohr-Coulomb line or on it; unknown "
      "without "
      "a friction angle",
      "Criteria: number of criteria that detected the collapse, of all criteria",
  };
}

TestContent test_content(const study::TestResult& reported) {
  const auto& test = reported.stored;
  TestContent content = begun_content(test);
  auto& facts = content.facts;
  add_tags(facts, test);
  add_revisions(facts, test);
  facts.push_back({"Specimen", {specimen_line(test.header.specimen)}});
  facts.push_back({"Start of shear", {shear_start_line(test)}});
  if (const auto& strength = test.summary.undrained_strength)
    facts.push_back({"Undrained strength", undrained_strength_lines(*strength)});
  add_collapse(facts, test);
  if (test.header.origin == Origin::recorded)
    facts.push_back({"Membrane correction", {membrane_line(test)}});
  if (auto list = note_lines(test.header.notes); !list.empty())
    facts.push_back({"From the file", std::move(list)});
  if (auto list = guess_lines(test.header.guesses); !list.empty())
    facts.push_back({"Assumed", std::move(list)});
  if (auto list = study::warnings(test); !list.empty())
    facts.push_back({"Warnings", std::move(list)});
  content.criteria = criteria_table(test);
  content.events = events_table(test);
  content.checks = checks_table(test);
  return content;
}

TestContent brief_content(const db::StoredTest& test) {
  TestContent content = begun_content(test);
  auto& facts = content.facts;
  facts.push_back({"Stored", {stored_line(test)}});
  facts.push_back({"SHA-256", {or_unknown(test.header.digest)}});
  add_tags(facts, test);
  add_revisions(facts, test);
  facts.push_back({"Specimen", {specimen_line(test.header.specimen)}});
  if (const auto& strength = test.summary.undrained_strength)
    facts.push_back({"Undrained strength", undrained_strength_lines(*strength)});
  facts.push_back({"Collapse", {verdict_line(test)}});
  if (auto list = study::warnings(test); !list.empty())
    facts.push_back({"Warnings", std::move(list)});
  return content;
}

}  // namespace triax::src
