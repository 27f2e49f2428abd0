// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/column_questions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/intake/names/lexicon.hpp"
#include "src/study/intake/column_evidence.hpp"

namespace triax::study {
namespace {

using About = ImportQuestion::About;

/// Quantities that are offered for any column.
constexpr std::array kCommonQuantities{"time",
                                       "axial_strain",
                                       "axial_displacement",
                                       "deviator_stress",
                                       "axial_force",
                                       "mean_effective_stress",
                                       "cell_pressure",
                                       "pore_pressure",
                                       "excess_pore_pressure",
                                       "back_pressure",
                                       "volumetric_strain",
                                       "volume_change",
                                       "effective_axial_stress",
                                       "effective_radial_stress"};

/// "axial strain"
std::string words_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

const ColumnChoice& column_at(const ImportChoices& choices, std::size_t position) {
  return *std::ranges::find(choices.columns, position, &ColumnChoice::position);
}

std::size_t index_of(const lab::Proposal& proposal, std::size_t position) {
  const auto found =
      std::ranges::find(proposal.table.columns, position, &lab::TableColumn::position);
  return static_cast<std::size_t>(found - proposal.table.columns.begin());
}

/// "column 3 'q (kPa)'"
std::string column_name(const ColumnChoice& column) {
  return column.heading.empty()
             ? fmt::format("column {}", column.position)
             : fmt::format("column {} {}", column.position, lab::excerpt(column.heading));
}

void add_once(std::vector<ImportAnswer>& answers, const std::string& value, std::string text) {
  if (std::ranges::find(answers, value, &ImportAnswer::value) == answers.end())
    answers.push_back({value, std::move(text)});
}

}  // namespace

ImportQuestion quantity_question(const lab::Proposal& proposal, const ImportChoices& choices,
                                 std::size_t position) {
  const ColumnChoice& column = column_at(choices, position);
  const std::size_t index = index_of(proposal, position);
  const lab::ColumnMeaning& meaning = proposal.meaning.columns[index];
  ImportQuestion out{.about = About::quantity,
                     .position = position,
                     .text = "quantity of " + column_name(column),
                     .explanation = "A column that is not used changes nothing."};
  if (meaning.reading.quantity && !meaning.is_decided())
    out.explanation =
        fmt::format("{}: {}. It fits better than {} by {:.1f}; {:.1f} would decide.",
                    words_of(meaning.reading.quantity->name), column_evidence(proposal, index),
                    meaning.other->quantity ? words_of(meaning.other->quantity->name) : kNotUsed,
                    meaning.lead, lab::ColumnMeaning::kDecided);
  const auto add = [&](const std::string& name) {
    const auto other = std::ranges::find(choices.columns, name, &ColumnChoice::quantity);
    const bool is_taken = other != choices.columns.end() && other->position != position;
    if (is_of_record(name))
      add_once(out.answers, name,
               words_of(name) + (is_taken ? fmt::format(" (now column {})", other->position) : ""));
  };
  add(column.quantity);
  if (meaning.reading.quantity) add(meaning.reading.quantity->name);
  if (meaning.other && meaning.other->quantity) add(meaning.other->quantity->name);
  for (const lab::NameCandidate& one : lab::find_names(column.heading).candidates)
    add(one.quantity->name);
  for (const char* name : kCommonQuantities) add(name);
  add_once(out.answers, kTestColumn, "name or number of the test");
  add_once(out.answers, kNotUsed, kNotUsed);
  out.usual = is_of_record(column.quantity) ? column.quantity : kNotUsed;
  return out;
}

std::optional<ImportQuestion> unit_question(const lab::Proposal& proposal,
                                            const ImportChoices& choices, std::size_t position) {
  const ColumnChoice& column = column_at(choices, position);
  const auto* quantity = lab::find_lexicon_quantity(column.quantity);
  if (!quantity || proposal.table.columns[index_of(proposal, position)].clock) return std::nullopt;
  const auto units = lab::unsaid_units(*quantity);
  if (units.empty()) return std::nullopt;
  ImportQuestion out{
      .about = About::unit,
      .position = position,
      .text = fmt::format("unit of {}, {}", column_name(column), words_of(column.quantity)),
      .explanation = "Neither the heading nor the readings decide it.",
      .usual = column.unit.empty() ? units.front() : column.unit};
  add_once(out.answers, out.usual, out.usual);
  for (const std::string& unit : units)
    add_once(out.answers, unit, unit == "-" ? "- (a plain number)" : unit);
  return out;
}

std::optional<ImportQuestion> sign_question(const ImportChoices& choices, std::size_t position) {
  const ColumnChoice& column = column_at(choices, position);
  const auto* quantity = lab::find_lexicon_quantity(column.quantity);
  constexpr std::array kSigned{"length", "pressure", "force", "volume"};
  const bool has_sign =
      quantity && (std::ranges::find(kSigned, quantity->dimension) != kSigned.end() ||
                   quantity->name.ends_with("strain"));
  if (!has_sign) return std::nullopt;
  const bool is_water = quantity->name == "back_volume" || quantity->name == "cell_volume";
  const std::string positive = is_water                            ? "water into it is positive"
                               : quantity->name == "volume_change" ? "water out is positive"
                                                                   : "compression is positive";
  const std::string negative = is_water                            ? "water into it is negative"
                               : quantity->name == "volume_change" ? "water out is negative"
                                                                   : "compression is negative";
  return ImportQuestion{
      .about = About::sign,
      .position = position,
      .text = fmt::format("sign of {}, {}", column_name(column), words_of(column.quantity)),
      .explanation = "Laboratories count it either way, and the readings do not decide it.",
      .answers = {{"1", positive}, {"-1", negative}},
      .usual = column.sign < 0 ? "-1" : "1"};
}

std::optional<ImportQuestion> factor_question(const ImportChoices& choices, std::size_t position) {
  const ColumnChoice& column = column_at(choices, position);
  const bool is_force = column.quantity == "force_reading";
  if (!is_force && column.quantity != "dial_reading") return std::nullopt;
  return ImportQuestion{
      .about = About::factor,
      .position = position,
      .text = "factor of " + column_name(column),
      .explanation =
          fmt::format("The column has readings of a {}, and the file does not state its factor.",
                      is_force ? "proving ring" : "dial gauge"),
      .answers = {},
      .usual = is_force ? "" : "0.01",
      .unit = is_force ? "N per reading" : "mm per reading"};
}

ImportQuestion date_order_question(const lab::Proposal& proposal, const ImportChoices& choices,
                                   std::size_t position) {
  const ColumnChoice& column = column_at(choices, position);
  const lab::TableColumn& cells = proposal.table.columns[index_of(proposal, position)];
  return {.about = About::date_order,
          .position = column.position,
          .text = fmt::format("order of day and month in {}", column_name(column)),
          .explanation = fmt::format("The dates from {} to {} fit both orders.",
                                     lab::excerpt(cells.first_cell), lab::excerpt(cells.last_cell)),
          .answers = {{"day first", "day first: 31/12/2025"},
                      {"month first", "month first: 12/31/2025"}},
          .usual = std::string(lab::name(column.date_order.value_or(lab::DateOrder::day_first)))};
}

}  // namespace triax::study
