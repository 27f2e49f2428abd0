// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/verdict_sheet.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "lab/base/text.hpp"
#include "src/export/workbook/layout.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

class VerdictRows {
 public:
  explicit VerdictRows(Sheet& sheet) : sheet_(sheet) {}

  void heading(const std::string& words) {
    ++row_;
    sheet_.text(row_++, 0, words, Look::heading);
  }
  void text(const std::string& label, const std::string& words) {
    if (words.empty()) return;
    sheet_.text(row_, 0, label);
    sheet_.text(row_++, 1, words);
  }
  void number(const std::string& label, const std::optional<double>& value) {
    if (!value) return;
    sheet_.text(row_, 0, label);
    sheet_.number(row_++, 1, *value);
  }
  void table(const std::string& title, const Table& table) {
    if (table.rows.empty()) return;
    heading(title);
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      sheet_.text(row_, i, table.columns[i].heading, Look::heading);
    ++row_;
    for (const auto& cells : table.rows) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto value = lab::whole_text_as<double>(cells[i]);
        if (value)
          sheet_.number(row_, i, *value);
        else
          sheet_.text(row_, i, cells[i]);
      }
      ++row_;
    }
  }

 private:
  Sheet& sheet_;
  std::size_t row_ = kHeadingRow;
};

std::optional<double> kilopascals(const std::optional<double>& pa) {
  return pa ? std::optional(*pa / 1e3) : std::nullopt;
}

std::optional<double> plain_number(const std::optional<std::int64_t>& number) {
  return number ? std::optional(static_cast<double>(*number)) : std::nullopt;
}

std::string answer(const db::StoredTest& test) {
  if (test.status != db::TestStatus::complete) return "not assessed: the test is not complete";
  if (!study::has_verdict(test)) return "not assessed";
  return test.summary.collapse.detected() ? "collapse" : "none";
}

void add_instant(VerdictRows& rows, const lab::Instant& at) {
  rows.number("reading", static_cast<double>(at.reading));
  rows.number("time_s", at.time_s);
  rows.number("axial_strain", at.axial_strain);
  rows.number("deviator_stress_kPa", kilopascals(at.q_pa));
  rows.number("mean_effective_stress_kPa", kilopascals(at.p_eff_pa));
  rows.number("pore_pressure_kPa", kilopascals(at.pore_pressure_pa));
  rows.number("stress_ratio", at.eta());
  if (!at.interval) return;
  rows.number("stress_ratio, low end of 95 %", at.interval->eta.low);
  rows.number("stress_ratio, high end of 95 %", at.interval->eta.high);
}

void add_detected_at(VerdictRows& rows, const std::optional<lab::Moment>& at) {
  if (!at) return;
  rows.number("detected at reading", static_cast<double>(at->reading));
  rows.number("detected at time_s", at->time_s);
}

void add_total(VerdictRows& rows, const lab::TotalUncertainty& total) {
  rows.number("stress_ratio, low end of total uncertainty", total.interval.eta.low);
  rows.number("stress_ratio, high end of total uncertainty", total.interval.eta.high);
  for (const lab::UncertaintySource& source : total.budget)
    rows.number("fraction of variance: " + source.name, source.share);
}

void add_instants(VerdictRows& rows, const db::StoredTest& test) {
  const lab::Collapse& c = test.summary.collapse;
  if (const auto onset = study::collapse_onset(test)) {
    rows.heading("Onset of instability");
    add_instant(rows, *onset);
    add_detected_at(rows, c.onset_detected_at);
    if (onset->total) add_total(rows, *onset->total);
  }
  if (const auto failure = study::failure_onset(test)) {
    rows.heading("Failure, no collapse");
    add_instant(rows, *failure);
  }
  if (!c.loss_of_control) return;
  rows.heading("Loss of control");
  add_instant(rows, *c.loss_of_control);
  add_detected_at(rows, c.loss_of_control_detected_at);
}

}  // namespace

bool is_of_verdict(const Fact& fact) {
  constexpr std::array<std::string_view, 9> kOthers{
      "Type of test",        "Data",          "Tags",    "Specimen", "Start of shear",
      "Membrane correction", "From the file", "Assumed", "Warnings"};
  return std::ranges::find(kOthers, fact.label) == kOthers.end();
}

void write_verdict(Sheet& sheet, const db::StoredTest& test, const TestContent& content) {
  sheet.widths(0, 0, 34);
  sheet.widths(1, 6, 18);
  const lab::Collapse& c = test.summary.collapse;
  VerdictRows rows(sheet);
  rows.heading("Assessment");
  rows.text("answer", answer(test));
  const bool judged = study::has_verdict(test);
  if (judged && c.detected()) rows.text("kind", std::string(to_string(c.kind)));
  rows.number("assessed from reading", plain_number(c.judged_from));
  rows.number("assessed until reading", plain_number(c.judged_until));
  rows.text("reason for the end", c.judged_until_reason);
  if (judged) {
    if (c.detected()) rows.text("limit surface", inside_limit_surface(c));
    rows.number("limit_stress_ratio_M", c.limit_stress_ratio);
    rows.number("limit_intercept_kPa", kilopascals(c.limit_intercept_pa));
    rows.text("limit from", c.limit_source);
    rows.number("second_order_work_normalised", c.second_order_work_normalised);
    rows.number("second_order_work_error", c.second_order_work_error);
    rows.number("fraction of strength lost", c.strength_lost);
    if (c.nearest && !c.detected()) {
      rows.number("least second_order_work_normalised", c.nearest->normalised);
      rows.number("at reading", static_cast<double>(c.nearest->reading));
    }
  }
  if (const auto& strength = test.summary.undrained_strength) {
    rows.heading("Undrained strength");
    rows.number("undrained_strength_kPa", strength->c_u_pa() / 1e3);
    add_instant(rows, strength->at);
  }
  add_instants(rows, test);
  rows.heading("In words");
  for (const Fact& fact : content.facts)
    if (is_of_verdict(fact))
      for (const std::string& line : fact.lines) rows.text(fact.label, line);
  rows.table("Criteria", content.criteria);
  rows.table("Events", content.events);
  rows.table("Checks", content.checks);
}

}  // namespace triax::src
