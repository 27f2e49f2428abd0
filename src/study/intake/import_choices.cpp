// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/import_choices.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/intake/gauge_columns.hpp"
#include "lab/intake/questions.hpp"
#include "lab/records/row_completion.hpp"

namespace triax::study {
namespace {

bool is_date(const std::string& quantity) { return quantity == "clock" || quantity == "date"; }

bool is_clock_name(const std::string& quantity) {
  return is_date(quantity) || quantity == "time_of_day";
}

/// The key of [columns].
std::string key_of(const std::string& quantity) { return quantity == "clock" ? "time" : quantity; }

bool is_time_in_numbers(const ColumnChoice& column) { return column.quantity == "time"; }

WrittenColumn written_column(const ImportChoices& choices, const ColumnChoice& column) {
  WrittenColumn out{.quantity = key_of(column.quantity),
                    .position = column.position,
                    .unit = column.unit,
                    .sign = column.sign,
                    .factor = column.factor,
                    .date_order = column.date_order};
  out.remark = column.note.empty() ? lab::excerpt(column.heading) : column.note;
  out.is_commented = !is_of_record(column.quantity) || column_before(choices, column) != 0;
  return out;
}

/// Own records and others with metadata in TOML behind # in front of the headings.
bool has_toml_preamble(const lab::TableStructure& structure) {
  return std::ranges::any_of(structure.preamble, [](const std::string& line) {
    return line.starts_with("# [specimen]") || line.starts_with("# [test]");
  });
}

/// The source of the unit of a column that becomes another quantity.
lab::UnitSource unit_source_of(const ColumnChoice& choice, bool is_number,
                               const lab::ColumnReading& before) {
  using enum lab::UnitSource;
  const bool is_from_file = before.unit_source == heading || before.unit_source == row;
  if (is_from_file && before.unit == choice.unit) return before.unit_source;
  const auto* quantity = lab::find_lexicon_quantity(choice.quantity);
  return quantity && is_number && choice.factor == 1 && lab::unsaid_units(*quantity).size() > 1
             ? asked
             : name;
}

/// As far as the user decided it.
void apply_choice(const ColumnChoice& choice, bool is_number, lab::ColumnMeaning& meaning) {
  lab::ColumnReading& reading = meaning.reading;
  const bool is_same = reading.quantity && reading.quantity->name == choice.quantity;
  if (!is_same)
    reading = {.quantity = lab::find_lexicon_quantity(choice.quantity),
               .unit_source = unit_source_of(choice, is_number, reading)};
  if (choice.is_quantity_answered || !is_same) {
    meaning.other.reset();
    reading.name = lab::NameMatch::exact;
  }
  if (choice.is_unit_answered) reading.unit_source = lab::UnitSource::heading;
  reading.unit = choice.unit;
  reading.sign = choice.sign;
  if (!reading.quantity) return;
  for (const lab::UnitName* unit : lab::find_unit_names(choice.unit))
    if (const auto conversion = lab::conversion_to_canonical(*reading.quantity, *unit)) {
      reading.factor = conversion->factor;
      reading.offset = conversion->offset;
      return;
    }
}

/// Questions that the choices answer although the table does not.
bool is_answered(const lab::TableQuestion& question, const ImportChoices& choices) {
  using enum lab::TableQuestion::About;
  const auto column =
      std::ranges::find(choices.columns, question.position, &ColumnChoice::position);
  const bool has_column = column != choices.columns.end();
  switch (question.about) {
    case sign:
      return has_column && column->is_sign_answered;
    case unit:
      return has_column && column->is_unit_answered;
    case meaning:
      return has_column && column->is_quantity_answered;
    case date_order:
      return has_column && column->is_unit_answered;
    case definitions:
    case headings:
      return false;
    case value:
      break;
  }
  if (question.text == "height") return choices.value("specimen.height_mm") != nullptr;
  if (question.text == "diameter") return choices.value("specimen.diameter_mm") != nullptr;
  const bool has_cell = choices.constant("cell_pressure") != nullptr;
  const bool has_pore =
      choices.constant("back_pressure") != nullptr || choices.constant("pore_pressure") != nullptr;
  if (question.text == "cell pressure") return has_cell;
  if (question.text == "back pressure") return has_pore;
  return has_cell && has_pore;
}

ColumnChoice usual_choice(const lab::Proposal& proposal, std::size_t i) {
  const lab::TableColumn& column = proposal.table.columns[i];
  const lab::ColumnReading& reading = proposal.meaning.columns[i].reading;
  ColumnChoice out{.position = column.position, .heading = column.heading};
  if (column.position == proposal.test_column) {
    out.quantity = kTestColumn;
  } else if (has_quantity(reading)) {
    out.quantity = reading.quantity->name;
    if (!column.clock) out.unit = reading.unit;
    out.sign = reading.sign;
  }
  if (column.clock && column.clock->format->order != lab::DateOrder::none)
    out.date_order = column.clock->format->order;
  return out;
}

/// A force or a displacement that is a reading times a factor.
void take_gauge(const lab::GaugeColumn& gauge, ColumnChoice& choice) {
  constexpr double kMillimetres = 1e3;
  choice.quantity = gauge.is_force ? "axial_force" : "axial_displacement";
  choice.unit = gauge.is_force ? "N" : "mm";
  choice.sign = *gauge.scale < 0 ? -1 : 1;
  choice.factor = std::fabs(*gauge.scale) * (gauge.is_force ? 1 : kMillimetres);
}

}  // namespace

bool has_quantity(const lab::ColumnReading& reading) {
  return reading.quantity && reading.quantity->dimension != "any" &&
         reading.quantity->dimension != "text";
}

std::optional<double> first_value(const lab::Proposal& proposal, std::string_view quantity) {
  for (std::size_t i = 0; i < proposal.table.columns.size(); ++i) {
    const lab::ColumnReading& reading = proposal.meaning.columns[i].reading;
    if (!reading.quantity || reading.quantity->name != quantity) continue;
    const double first = proposal.table.columns[i].first;
    if (std::isfinite(first)) return reading.sign * (first * reading.factor + reading.offset);
  }
  return std::nullopt;
}

std::string second_pressure(const ImportChoices& choices) {
  const bool has_excess = std::ranges::find(choices.columns, "excess_pore_pressure",
                                            &ColumnChoice::quantity) != choices.columns.end();
  return has_excess ? "back_pressure" : "pore_pressure";
}

ColumnChoice* ImportChoices::at(std::size_t position) {
  const auto found = std::ranges::find(columns, position, &ColumnChoice::position);
  return found == columns.end() ? nullptr : &*found;
}

const WrittenConstant* ImportChoices::constant(std::string_view quantity) const {
  const auto found = std::ranges::find(constants, quantity, &WrittenConstant::quantity);
  return found == constants.end() ? nullptr : &*found;
}

const WrittenValue* ImportChoices::value(std::string_view key) const {
  const auto found = std::ranges::find(values, key, &WrittenValue::key);
  return found == values.end() ? nullptr : &*found;
}

void ImportChoices::set_constant(const std::string& quantity, double value,
                                 const std::string& unit) {
  std::erase_if(constants, [&](const WrittenConstant& one) { return one.quantity == quantity; });
  constants.push_back({quantity, value, unit});
}

void ImportChoices::set_value(const std::string& key, double value) {
  std::erase_if(values, [&](const WrittenValue& one) { return one.key == key; });
  values.push_back({key, value});
}

ImportChoices usual_choices(const lab::Proposal& proposal, const ImportSource& source) {
  ImportChoices out;
  out.name = source.name;
  out.encoding = source.encoding;
  out.separator = proposal.structure.separator;
  out.decimal = proposal.structure.decimal;
  out.thousands = proposal.structure.thousands;
  out.sheet = source.sheet;
  out.block = proposal.block;
  out.has_toml_preamble = has_toml_preamble(proposal.structure);
  for (std::size_t i = 0; i < proposal.table.columns.size(); ++i)
    out.columns.push_back(usual_choice(proposal, i));
  for (const lab::GaugeColumn& gauge : lab::find_gauge_columns(proposal))
    if (gauge.scale) take_gauge(gauge, out.columns[gauge.column]);
  return out;
}

std::size_t column_before(const ImportChoices& choices, const ColumnChoice& column) {
  const bool is_clock = is_clock_name(column.quantity);
  for (const ColumnChoice& other : choices.columns) {
    if (other.position == column.position) continue;
    if (is_clock && is_time_in_numbers(other)) return other.position;
    const bool is_before = other.position < column.position;
    if (is_before && !other.quantity.empty() && other.quantity == column.quantity)
      return other.position;
    // A clock is the whole time; date and time of day are its parts.
    if (is_clock && column.quantity != "clock" && other.quantity == "clock") return other.position;
  }
  return 0;
}

bool is_of_record(const std::string& quantity) {
  return is_clock_name(quantity) || quantity == "time" || quantity == "stage_time" ||
         quantity == "stage" || quantity == kTestColumn || lab::find_quantity(quantity) ||
         lab::find_source_quantity(quantity);
}

lab::Proposal apply_choices(const lab::Proposal& proposal, const ImportChoices& choices) {
  lab::Proposal out = proposal;
  bool are_all_named = true;
  for (std::size_t i = 0; i < out.table.columns.size(); ++i) {
    const auto choice =
        std::ranges::find(choices.columns, out.table.columns[i].position, &ColumnChoice::position);
    if (choice == choices.columns.end()) continue;
    are_all_named = are_all_named && choice->is_quantity_answered;
    apply_choice(*choice, out.table.columns[i].sample.is_number, out.meaning.columns[i]);
  }
  out.are_columns_named = are_all_named;
  out.questions = lab::find_questions(out);
  std::erase_if(out.questions,
                [&](const lab::TableQuestion& one) { return is_answered(one, choices); });
  return out;
}

WrittenDialect dialect_of(const ImportChoices& choices) {
  WrittenDialect out{.name = choices.name,
                     .encoding = choices.encoding,
                     .separator = lab::separator_name(choices.separator),
                     .decimal = std::string(1, static_cast<char>(choices.decimal)),
                     .thousands = choices.thousands == 0 ? "" : std::string(1, choices.thousands),
                     .sheet = choices.sheet,
                     .block = choices.block,
                     .has_toml_preamble = choices.has_toml_preamble,
                     .values = choices.values,
                     .programme = choices.programme};
  for (const ColumnChoice& column : choices.columns)
    if (column.quantity.empty())
      out.remarks.push_back(
          fmt::format("not used: column {} {}", column.position, lab::excerpt(column.heading)));
    else
      out.columns.push_back(written_column(choices, column));
  for (const WrittenConstant& one : choices.constants)
    if (std::ranges::find(choices.columns, one.quantity, &ColumnChoice::quantity) ==
        choices.columns.end())
      out.constants.push_back(one);
  return out;
}

std::string dialect_text(const ImportChoices& choices) {
  return write_dialect(dialect_of(choices));
}

}  // namespace triax::study
