// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/proposal_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "lab/base/toml_reader.hpp"
#include "src/study/intake/import_choices.hpp"

namespace triax::src {
namespace {

using lab::Proposal;

const char* source_name(const lab::ColumnMeaning& meaning) {
  switch (meaning.reading.unit_source) {
    case lab::UnitSource::heading:
      return "heading";
    case lab::UnitSource::row:
      return "units row";
    case lab::UnitSource::name:
      return "name";
    case lab::UnitSource::none:
      return "none";
    case lab::UnitSource::format:
      return "format";
    case lab::UnitSource::identity:
      return "identity";
    case lab::UnitSource::asked:
      return "asked";
  }
  return "";
}

/// A question about the unit.
bool is_asked(const Proposal& proposal, std::size_t position) {
  return std::ranges::any_of(proposal.questions, [position](const lab::TableQuestion& question) {
    return question.position == position && question.about == lab::TableQuestion::About::unit;
  });
}

/// "candidates = [...]" for a column whose meaning is asked.
std::string candidates_text(const Proposal& proposal, std::size_t i) {
  const lab::ColumnMeaning& meaning = proposal.meaning.columns[i];
  const std::size_t position = proposal.table.columns[i].position;
  const bool is_open = std::ranges::any_of(proposal.questions,
                                           [position](const lab::TableQuestion& question) {
                                             using About = lab::TableQuestion::About;
                                             return (question.position == position &&
                                                     question.about == About::meaning) ||
                                                    question.about == About::definitions;
                                           }) &&
                       !meaning.is_decided();
  if (!is_open || !meaning.other || !meaning.other->quantity) return {};
  return fmt::format("candidates = [\"{}\", \"{}\"]\n", meaning.reading.quantity->name,
                     meaning.other->quantity->name);
}

std::string instant_text(const lab::ClockFormat& format, const std::string& cell) {
  const auto time = lab::read_clock(format, cell);
  if (!time) return {};
  std::string out;
  if (time->day) {
    const std::chrono::sys_days day{std::chrono::days{*time->day}};
    const std::chrono::year_month_day date{day};
    out = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                      static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  }
  if (!time->time_ns && time->day && !format.has_time) return out;
  constexpr std::int64_t kSecond = 1'000'000'000, kMinute = 60, kHour = 3600;
  const std::int64_t seconds = time->time_ns.value_or(0) / kSecond;
  if (!out.empty()) out += 'T';
  return out + fmt::format("{:02}:{:02}:{:02}", seconds / kHour, seconds / kMinute % kMinute,
                           seconds % kMinute);
}

void add_values(std::string& out, const lab::TableColumn& column,
                const lab::ColumnReading& reading) {
  if (column.clock && reading.quantity->name != "time" && reading.quantity->name != "stage_time") {
    out += fmt::format("first = \"{}\"\nlast = \"{}\"\n",
                       instant_text(*column.clock->format, column.first_cell),
                       instant_text(*column.clock->format, column.last_cell));
    return;
  }
  const auto write = [&](const char* key, double printed, const std::string& cell) {
    double value = reading.sign * (printed * reading.factor + reading.offset);
    if (column.clock) value = lab::clock_seconds(*column.clock->format, cell).value_or(NAN);
    if (std::isfinite(value)) out += fmt::format("{} = {}\n", key, value);
  };
  if (!column.sample.is_number && !column.clock) {
    out += fmt::format("first = {}\nlast = {}\n", lab::toml_quoted(column.first_cell),
                       lab::toml_quoted(column.last_cell));
    return;
  }
  write("first", column.first, column.first_cell);
  write("last", column.last, column.last_cell);
}

/// The table as text: separators, lines and the tests in it.
std::string structure_text(const std::vector<Proposal>& proposals, const std::string& file,
                           const std::string& encoding) {
  const Proposal& front = proposals.front();
  const auto& structure = front.structure;
  std::string out = fmt::format(
      "file = {}\nencoding = {}\nseparator = {}\ndecimal = \"{}\"\nheading_lines = [{}]\n"
      "unit_line = {}\n",
      lab::toml_quoted(file), lab::toml_quoted(encoding),
      lab::toml_quoted(lab::separator_name(structure.separator)),
      static_cast<char>(structure.decimal), fmt::join(structure.heading_lines, ", "),
      structure.unit_line);
  out += fmt::format("data_lines = [{}]\n", fmt::join(front.table.row_lines, ", "));
  const std::size_t tests = std::max(proposals.size(), front.test_begins.size());
  if (tests > 1) out += fmt::format("tests = {}\n", tests);
  if (front.is_reversed) out += "row_order = \"reversed\"\n";
  return out;
}

/// Questions, each once, and cells without a value.
std::string questions_text(const std::vector<Proposal>& proposals) {
  std::vector<std::string> asked, missing;
  for (const Proposal& one : proposals) {
    for (const auto& question : one.questions) {
      const auto text = lab::toml_quoted(question.text);
      if (std::ranges::find(asked, text) == asked.end()) asked.push_back(text);
    }
    for (const auto& [line, position] : one.table.missing)
      missing.push_back(fmt::format("[{}, {}]", line, position));
  }
  return fmt::format("ask = [{}]\nmissing = [{}]\n", fmt::join(asked, ", "),
                     fmt::join(missing, ", "));
}

/// Values of labels, the first of each key.
std::string labels_text(const std::vector<lab::LabelValue>& labels) {
  std::string out = "\n[labels]\n";
  std::vector<std::string> keys;
  for (const lab::LabelValue& label : labels) {
    if (!label.value || label.is_ambiguous) continue;
    const auto dot = label.metadata.rfind('.');
    std::string key = dot == std::string::npos ? label.name : label.metadata.substr(dot + 1);
    if (key == "cell_pressure" || key == "back_pressure" || key == "effective_consolidation_stress")
      key += "_kPa";
    if (std::ranges::find(keys, key) != keys.end()) continue;
    keys.push_back(key);
    out += fmt::format("{} = {}\n", key, *label.value);
  }
  return out;
}

std::string column_text(const Proposal& one, std::size_t i) {
  const lab::TableColumn& column = one.table.columns[i];
  const lab::ColumnReading& reading = one.meaning.columns[i].reading;
  const bool has_headings = !one.structure.heading_lines.empty();
  const char* const unnamed = has_headings ? "ignored" : "asked";
  std::string out =
      fmt::format("\n[[columns]]\nposition = {}\nheading = {}\nquantity = \"{}\"\n",
                  column.position, lab::toml_quoted(column.heading),
                  has_headings && reading.quantity ? reading.quantity->name : unnamed);
  if (!study::has_quantity(reading) || !has_headings) return out;
  out += fmt::format("unit = {}\nunit_source = \"{}\"\nfactor = {}\nsign = {}\n",
                     lab::toml_quoted(reading.unit),
                     is_asked(one, column.position) ? "asked" : source_name(one.meaning.columns[i]),
                     reading.factor, reading.sign);
  out += candidates_text(one, i);
  add_values(out, column, reading);
  return out;
}

}  // namespace

std::string meaning_text(const std::vector<Proposal>& proposals, const std::string& file,
                         const std::string& encoding) {
  std::string out = structure_text(proposals, file, encoding) + questions_text(proposals) +
                    labels_text(proposals.front().labels);
  for (const Proposal& one : proposals)
    for (std::size_t i = 0; i < one.table.columns.size(); ++i) out += column_text(one, i);
  return out;
}

}  // namespace triax::src
