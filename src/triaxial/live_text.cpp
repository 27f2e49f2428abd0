// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/live_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/warning/warning_words.hpp"
#include "src/output/sentence_table.hpp"
#include "src/output/words.hpp"
#include "src/triaxial/facts/collapse_fact.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"
#include "src/triaxial/text_report.hpp"

namespace triax::src {
namespace {

std::string said_word(const study::LiveRow& row) {
  if (!row.event) return "forecast";
  switch (row.event->kind) {
    case lab::EventKind::stage_started:
      return "begins";
    case lab::EventKind::loss_of_sustainability:
      return "lost";
    case lab::EventKind::limit_surface:
    case lab::EventKind::failure:
      return "failure";
    case lab::EventKind::warning_withdrawn:
      return "withdrawn";
    default:
      return spaced(std::string(to_string(row.event->kind)));
  }
}

std::string left_words(const lab::LeftToOnset& left) {
  if (!(left.value > 0)) return "none: passed";
  switch (left.quantity) {
    case lab::Quantity::deviator_stress:
      return fmt::format("{:.2f} kPa of q", left.value / 1e3);
    case lab::Quantity::mean_effective_stress:
      return fmt::format("{:.2f} kPa of p′", left.value / 1e3);
    case lab::Quantity::axial_strain:
      return fmt::format("{:.3f} % of ε₁", left.value * 100);
    default:
      return fmt::format("{:.4g} {}", in_field_units(left), spaced(lab::heading(left.quantity)));
  }
}

/// The words of a level are the forecast, which has columns of its own.
std::string sentence(const study::LiveRow& row) {
  if (!row.event) return {};
  const lab::Event& event = *row.event;
  if (row.forecast && event.kind != lab::EventKind::warning_withdrawn) return {};
  if (event.kind == lab::EventKind::warning_withdrawn)
    return row.forecast ? std::string() : event.detail;
  const bool of_another = !row.said || row.said->reading != event.reading;
  return of_another ? fmt::format("at reading {}: {}", event.reading, event.detail) : event.detail;
}

Table rows_table(const std::vector<study::LiveRow>& rows) {
  Table table{{{"Reading", Align::right},
               {"Time", Align::right},
               {"Stage", Align::right},
               {"Event"},
               {"η now", Align::right},
               {"η at onset", Align::right},
               {"with 90 %", Align::right},
               {"left until onset", Align::right},
               {"at this rate", Align::right},
               {"Words"}},
              {}};
  for (const study::LiveRow& row : rows) {
    const auto& f = row.forecast;
    const bool left = f && f->left;
    table.rows.push_back(
        {row.said ? fmt::format("{}", row.said->reading) : "end",
         row.said ? duration(row.said->time_s) : kUnknown,
         row.stage ? fmt::format("{}", *row.stage) : kUnknown, said_word(row), number(row.eta, 3),
         f ? number(f->eta, 3) : "",
         f ? fmt::format("{} to {}", number(f->eta_low, 3), number(f->eta_high, 3)) : "",
         left ? left_words(*f->left) : "",
         left && f->left->value > 0 ? duration(f->left->time_s) : "", sentence(row)});
  }
  return table;
}

std::string before_onset(std::int64_t readings, const std::optional<double>& time_s) {
  std::string words =
      fmt::format("{} reading{}", std::abs(readings), std::abs(readings) == 1 ? "" : "s");
  if (time_s) words += " and " + duration(std::abs(*time_s));
  return words + (readings >= 0 ? " before the onset" : " after the onset");
}

std::string lead_line(const study::LiveLead& lead, const lab::Instant& onset) {
  const lab::Forecast& o = lead.forecast;
  if (o.cyclic)
    return fmt::format("{}; {}", before_onset(lead.readings, lead.time_s), lab::describe(o));
  std::string line =
      fmt::format("{}; η forecast {} ({} to {})", before_onset(lead.readings, lead.time_s),
                  number(o.eta, 3), number(o.eta_low, 3), number(o.eta_high, 3));
  if (!onset.eta()) return line;
  const double off = std::fabs(o.eta) - std::fabs(*onset.eta());
  const bool holds = o.eta_low <= *onset.eta() && *onset.eta() <= o.eta_high;
  return line + fmt::format(", {} too {}, {}", number(std::fabs(off), 3), off < 0 ? "low" : "high",
                            holds ? "within its interval" : "outside its interval");
}

std::string level_line(lab::EventKind kind, const std::optional<lab::Forecast>& stands,
                       const std::optional<study::LiveLead>& lead, const db::StoredTest& test) {
  if (lead) return lead_line(*lead, *test.summary.collapse.onset);
  if (stands)
    return fmt::format("issued at reading {} and not withdrawn; no onset was found",
                       stands->reading);
  const auto said = std::ranges::count(test.events, kind, &lab::Event::kind);
  if (said == 0) return "never issued";
  return said == 1 ? "issued once and withdrawn"
                   : fmt::format("issued {} times and withdrawn", said);
}

std::string onset_line(const study::LiveAccount& account) {
  if (!account.onset) return "no onset was found";
  std::string line = instant(*account.onset);
  if (const auto& at = account.onset->interval)
    line += fmt::format("; η {} to {} with 95 %", number(at->eta.low, 3), number(at->eta.high, 3));
  return line;
}

std::string lost_line(const lab::Collapse& collapse, const lab::Instant& onset) {
  if (!collapse.onset_detected_at) return "not detected before the end of the record";
  const lab::Moment& at = *collapse.onset_detected_at;
  std::optional<double> time_s;
  if (at.time_s && onset.time_s) time_s = *onset.time_s - *at.time_s;
  return fmt::format("detected at reading {}, {}", at.reading,
                     before_onset(onset.reading - at.reading, time_s));
}

std::vector<Fact> compared(const db::StoredTest& test, const study::LiveAccount& account) {
  const lab::Collapse& c = test.summary.collapse;
  std::vector<Fact> facts = {{"result", {verdict_line(test)}},
                             {"onset of instability", {onset_line(account)}}};
  using enum lab::EventKind;
  facts.push_back(
      {"approaching", {level_line(approaching, c.approaching, account.approaching, test)}});
  facts.push_back({"imminent", {level_line(imminent, c.imminent, account.imminent, test)}});
  if (account.onset && c.detected()) facts.push_back({"lost", {lost_line(c, *account.onset)}});
  if (c.loss_of_control)
    facts.push_back({"loss of control",
                     {instant(*c.loss_of_control),
                      detected_line(*c.loss_of_control, c.loss_of_control_detected_at)}});
  if (test.summary.truth) facts.push_back({"true onset", {truth_line(*test.summary.truth)}});
  return facts;
}

}  // namespace

std::string live_text(const db::StoredTest& test, const study::LiveAccount& account) {
  TestContent head;
  head.title = fmt::format("Test {}: {}, reports while it ran", test.id, test.header.name);
  if (test.header.origin == lab::Origin::simulated) head.banner = "SIMULATED, not measured";
  std::string text = text_of(head) + '\n' + text_with_sentences(rows_table(account.rows));
  text += account.forecasts == 0 ? "\nNo onset was forecast at any point of second-order work.\n"
                                 : fmt::format(
                                       "\n{} of {} forecasts are shown between the events; triax "
                                       "query forecasts lists all.\n",
                                       account.shown, account.forecasts);
  return text + "\nCompared with the result\n" + facts_text(compared(test, account));
}

}  // namespace triax::src
