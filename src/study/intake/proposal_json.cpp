// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/proposal_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/intake/names/record_units.hpp"
#include "lab/intake/proposal.hpp"
#include "lab/intake/text/encoding.hpp"
#include "lab/intake/text/row_model.hpp"
#include "lab/records/row_completion.hpp"
#include "src/study/intake/column_evidence.hpp"
#include "src/study/intake/import_choices.hpp"
#include "src/study/intake/import_questions.hpp"
#include "src/study/intake/value_questions.hpp"

namespace triax::study {
namespace {

constexpr std::size_t kMaxColumns = 256;
constexpr std::size_t kPreviewRows = 10;

/// A text of the file, cut to `max_bytes`, as valid UTF-8.
std::string cut_text(std::string_view text, std::size_t max_bytes) {
  std::string out(text.substr(0, max_bytes));
  if (text.size() > max_bytes) {
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0U) == 0x80U)
      out.pop_back();
    if (!out.empty() && static_cast<unsigned char>(out.back()) >= 0xC0U) out.pop_back();
    out += "…";
  }
  return lab::is_utf8(out) ? out : lab::utf8_from_cp1252(out);
}

Json quantity_json(std::string_view name, std::string_view symbol, sim::Dimension dimension) {
  return {{"name", name}, {"symbol", symbol}, {"units", lab::record_units(dimension)}};
}

/// The quantities that can be chosen for a column.
Json quantities_json() {
  Json all = Json::array();
  for (const char* name : {"time", "stage_time"})
    all.push_back(quantity_json(name, "t", sim::Dimension::time));
  for (const char* name : {"date", "time_of_day", "stage", "test"})
    all.push_back({{"name", name}, {"symbol", ""}, {"units", Json::array()}});
  for (const lab::QuantityInfo& row : lab::quantities())
    all.push_back(quantity_json(row.name, row.symbol, sim::find_unit(row.unit)->dimension));
  for (const lab::SourceInfo& row : lab::source_quantities())
    all.push_back(quantity_json(row.name, "", sim::find_unit(row.unit)->dimension));
  return all;
}

/// True if the page shows the quantity: the user chooses all those of a table without headings.
bool is_shown(const lab::Proposal& proposal, const ImportChoices& choices,
              const ColumnChoice& choice, const lab::ColumnReading& reading) {
  if (choice.is_quantity_answered) return !choice.quantity.empty();
  return !proposal.structure.heading_lines.empty() && is_of_record(choice.quantity) &&
         reading.offset == 0 && column_before(choices, choice) == 0;
}

Json column_json(const lab::Proposal& proposal, const ImportChoices& choices, std::size_t i) {
  const lab::TableColumn& column = proposal.table.columns[i];
  const lab::ColumnReading& reading = proposal.meaning.columns[i].reading;
  const ColumnChoice& choice = choices.columns[i];
  const auto& units = proposal.structure.units;
  constexpr std::size_t kMaxHeading = 120;
  Json out = {
      {"position", column.position},
      {"heading", cut_text(column.heading, kMaxHeading)},
      {"unit_below",
       column.position <= units.size() ? cut_text(units[column.position - 1], kMaxHeading) : ""},
      {"clock", column.clock.has_value()},
      {"quantity", nullptr},
      {"unit", ""},
      {"sign", 1},
      {"factor", 1},
      {"date_order", nullptr},
      {"evidence", choice_evidence(proposal, choice, i)}};
  if (!is_shown(proposal, choices, choice, reading)) return out;
  const bool is_unit_open = reading.unit_source == lab::UnitSource::asked &&
                            !choice.is_unit_answered && choice.factor == 1;
  out["quantity"] = choice.quantity == "clock" ? "time" : choice.quantity;
  if (!is_unit_open) out["unit"] = cut_text(choice.unit, kMaxHeading);
  out["sign"] = choice.sign;
  out["factor"] = choice.factor;
  if (choice.date_order) out["date_order"] = lab::name(*choice.date_order);
  return out;
}

Json columns_json(const lab::Proposal& proposal, const ImportChoices& choices) {
  Json columns = Json::array();
  for (std::size_t i = 0; i < std::min(kMaxColumns, choices.columns.size()); ++i)
    columns.push_back(column_json(proposal, choices, i));
  return columns;
}

/// The columns that a dialect names by their place and its constants; other columns are unused.
void take_remembered(ImportChoices& choices, const std::string& file) {
  const auto document = lab::TomlTable::read(file);
  const auto columns = document.table("columns");
  for (ColumnChoice& column : choices.columns) {
    column.quantity.clear();
    column.is_quantity_answered = true;
  }
  for (const std::string& key : columns->keys()) {
    if (!columns->is_table(key)) continue;
    const auto table = *columns->table(key);
    if (const auto value = table.number("value"))
      choices.set_constant(key, *value, table.text("unit").value_or(""));
    const auto position = table.integer("column").value_or(0);
    ColumnChoice* const column =
        position > 0 ? choices.at(static_cast<std::size_t>(position)) : nullptr;
    if (!column) continue;
    column->quantity = key;
    column->unit = table.text("unit").value_or("");
    column->sign = table.number("sign").value_or(1) < 0 ? -1 : 1;
    column->factor = table.number("factor").value_or(1);
    if (const auto order = table.text("date_order"))
      column->date_order = lab::find_date_order(*order);
    column->note = "remembered for these headings";
    column->is_unit_answered = column->is_sign_answered = true;
  }
  if (const auto defaults = document.table("defaults"))
    choices.programme = defaults->text("programme").value_or("");
}

// Questions ---------------------------------------------------------------------------------------

/// In the order of ImportQuestion::About.
constexpr std::array kAboutNames{"quantity",   "unit",        "sign",      "factor",
                                 "date_order", "definitions", "programme", "value"};

Json question_json(const ImportQuestion& question) {
  Json answers = Json::array();
  if (question.position == 0)
    for (const ImportAnswer& answer : question.answers)
      answers.push_back({{"value", answer.value}, {"text", answer.text}});
  return {{"about", kAboutNames.at(static_cast<std::size_t>(question.about))},
          {"column", question.position},
          {"text", question.text},
          {"explanation", question.explanation},
          {"answers", std::move(answers)}};
}

/// One question for all columns without headings.
Json questions_json(const std::vector<ImportQuestion>& open, bool has_headings) {
  constexpr std::size_t kMaxQuestions = 100;
  Json all = Json::array();
  if (!has_headings)
    all.push_back(question_json({.about = ImportQuestion::About::quantity,
                                 .text = "quantity of each column",
                                 .explanation = "The table has no headings.",
                                 .answers = {},
                                 .usual = ""}));
  for (const ImportQuestion& question : open)
    if (has_headings && all.size() < kMaxQuestions) all.push_back(question_json(question));
  return all;
}

/// Values that a user can give. A consolidation stress is given as two pressures.
Json values_json() {
  Json all = Json::array();
  for (const AskedValue& value : asked_values())
    if (value.key != kConsolidationStress)
      all.push_back({{"key", value.key},
                     {"label", value.text},
                     {"unit", value.unit},
                     {"usual", value.usual}});
  return all;
}

/// Keys of values_json().
Json asked_json(const std::vector<ImportQuestion>& open) {
  Json keys = Json::array();
  for (const ImportQuestion& question : open)
    if (question.key == kConsolidationStress)
      keys.insert(keys.end(), {"test.cell_pressure_kPa", "back_pressure"});
    else if (!question.key.empty())
      keys.push_back(question.key);
  return keys;
}

/// Numbers that lines above the table state, by keys of values_json().
Json stated_json(const lab::Proposal& proposal) {
  Json values = Json::object();
  for (const AskedValue& value : asked_values())
    if (const auto* const label = value.label(proposal);
        label && label->value && !label->is_ambiguous)
      values[std::string(value.key)] = *label->value;
  return values;
}

/// The first rows, only the cells of these columns.
Json rows_json(const lab::Proposal& proposal, const lab::TableSample& sample) {
  constexpr std::size_t kMaxCell = 40;
  Json rows = Json::array();
  for (std::size_t i = 0; i < sample.size() && rows.size() < kPreviewRows; ++i) {
    if (!std::ranges::binary_search(proposal.table.row_lines, sample.number(i))) continue;
    const auto cells = lab::cells_of(sample.line(i), proposal.structure.separator);
    Json row = Json::array();
    for (const lab::TableColumn& column : proposal.table.columns) {
      if (row.size() == kMaxColumns) break;
      row.push_back(column.position <= cells.size() ? cut_text(cells[column.position - 1], kMaxCell)
                                                    : "");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Json table_json(const lab::Proposal& proposal, const lab::TableSample& sample,
                const std::optional<lab::RememberedDialect>& remembered) {
  ImportChoices choices = usual_choices(proposal, {});
  if (remembered) take_remembered(choices, remembered->file);
  const std::vector<ImportQuestion> open = open_questions(proposal, choices);
  return {{"block", proposal.block},
          {"columns", columns_json(proposal, choices)},
          {"rows", rows_json(proposal, sample)},
          {"questions", questions_json(open, !proposal.structure.heading_lines.empty())},
          {"asked", asked_json(open)},
          {"stated", stated_json(proposal)}};
}

}  // namespace

Json proposal_json(lab::ByteSource& table, const lab::DialectMemory& memory) {
  const std::vector<lab::Proposal> proposals = lab::propose(table);
  const lab::TableSample sample = lab::read_sample(table);
  const lab::TableStructure& structure = proposals.front().structure;
  const auto remembered = memory.find(structure);
  const auto* const text = dynamic_cast<const lab::Utf8Source*>(&table);
  Json tables = Json::array();
  for (const lab::Proposal& one : proposals) tables.push_back(table_json(one, sample, remembered));
  return {{"encoding", text ? text->encoding().name : "UTF-8"},
          {"separator", lab::separator_name(structure.separator)},
          {"decimal", std::string(1, static_cast<char>(structure.decimal))},
          {"thousands", structure.thousands == 0 ? "" : std::string(1, structure.thousands)},
          {"key", json_text(lab::DialectMemory::key_of(structure))},
          {"remembered", remembered ? Json(remembered->file) : Json()},
          {"tables", std::move(tables)},
          {"quantities", quantities_json()},
          {"values", values_json()}};
}

}  // namespace triax::study
