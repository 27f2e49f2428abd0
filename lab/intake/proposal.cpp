// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/proposal.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/gauge_columns.hpp"
#include "lab/intake/labels_above.hpp"
#include "lab/intake/questions.hpp"
#include "lab/intake/row_course.hpp"
#include "lab/intake/stage_time.hpp"

namespace triax::lab {
namespace {

SpecimenValues specimen_of(const std::vector<LabelValue>& labels) {
  SpecimenValues out;
  for (const LabelValue& label : labels) {
    if (!label.value || label.is_ambiguous) continue;
    if (label.name == "height" && !out.height_mm) out.height_mm = label.value;
    if (label.name == "diameter" && !out.diameter_mm) out.diameter_mm = label.value;
  }
  return out;
}

/// A column of dates or times of day as what its cells are.
void settle_clock(const TableColumn& column, ColumnMeaning& meaning) {
  if (!column.clock) return;
  const ClockFormat& format = *column.clock->format;
  const bool has_date = format.order != DateOrder::none || format.number != ClockNumber::none;
  const char* name = "time_of_day";
  const auto is_known = [](double value) { return !std::isnan(value); };
  const auto& values = column.clock_values;
  const auto first = std::ranges::find_if(values, is_known);
  const auto last = std::find_if(values.rbegin(), values.rend(), is_known);
  // The rows may be in reverse order.
  const bool begins_at_zero = !has_date && first != values.end() && (*first == 0 || *last == 0);
  if (format.is_elapsed || begins_at_zero)
    name = "time";
  else if (has_date && (format.has_time || format.number != ClockNumber::none))
    name = "clock";
  else if (has_date)
    name = "date";
  if (format.number == ClockNumber::part_of_day) name = "time_of_day";
  ColumnReading& reading = meaning.reading;
  const bool is_stage_time = reading.quantity && reading.quantity->name == "stage_time";
  if (is_stage_time && !has_date) return;
  reading.quantity = find_lexicon_quantity(name);
  reading.unit_source = UnitSource::name;
  meaning.other.reset();
}

/// If the file does not have one.
void set_unit(ColumnReading& reading, const std::string& unit) {
  const bool is_open =
      reading.unit_source == UnitSource::identity || reading.unit_source == UnitSource::asked;
  if (!is_open || !reading.quantity) return;
  for (const UnitName* one : find_unit_names(unit))
    if (const auto factor = factor_to_canonical(*reading.quantity, *one)) {
      reading.unit = unit;
      reading.factor = *factor;
      reading.unit_source = UnitSource::format;
      return;
    }
}

const SoftwareColumn* software_column(const Proposal& proposal, std::size_t i) {
  const std::string& heading = proposal.table.columns[i].heading;
  return proposal.software ? find_software_column(*proposal.software, heading) : nullptr;
}

/// Sets the units of the software for columns whose file states none.
void set_software_units(Proposal& proposal) {
  for (std::size_t i = 0; i < proposal.table.columns.size(); ++i) {
    const SoftwareColumn* const known = software_column(proposal, i);
    if (!known || known->unit.empty()) continue;
    ColumnMeaning& meaning = proposal.meaning.columns[i];
    set_unit(meaning.reading, known->unit);
    if (meaning.reading.unit_source == UnitSource::format) meaning.other.reset();
  }
}

TableStructure structure_of(const TableSample& sample, const ByteSource& source) {
  StructureResult found = find_structure(sample);
  if (!found.structure) throw BadInput(source.name(), 0, found.reason);
  return std::move(*found.structure);
}

Meaning meaning_of(const std::vector<ColumnSample>& samples, const Proposal& proposal) {
  Meaning out = find_meaning(samples, specimen_of(proposal.labels));
  for (std::size_t i = 0; i < proposal.table.columns.size(); ++i)
    settle_clock(proposal.table.columns[i], out.columns[i]);
  return out;
}

void decide_meaning(Proposal& proposal) {
  std::vector<ColumnSample> samples;
  for (std::size_t i = 0; i < proposal.table.columns.size(); ++i) {
    samples.push_back(proposal.table.columns[i].sample);
    if (const SoftwareColumn* const known = software_column(proposal, i))
      samples.back().software_sign = known->sign;
  }
  proposal.meaning = meaning_of(samples, proposal);
  if (const auto column = find_stage_time(proposal.table, proposal.meaning)) {
    samples[*column] =
        stage_time_sample(samples[*column], proposal.meaning.columns[*column].reading);
    proposal.meaning = meaning_of(samples, proposal);
  }
  set_software_units(proposal);
  settle_dial_factor(proposal);
}

Proposal propose_block(const TableSample& sample, const TableStructure& structure,
                       std::size_t number) {
  const TableBlock block = number == 0 ? TableBlock{} : structure.blocks.at(number - 1);
  Proposal out;
  out.structure = structure;
  out.block = number;
  out.labels = labels_above(structure, number);
  out.table = read_columns(sample, structure, block);
  std::string head;
  for (const std::string& line : structure.preamble) head += line + '\n';
  out.software = find_software(structure.headings, head);
  decide_meaning(out);
  for (const LabelValue& label : out.labels)
    if (label.name == "programme" && !out.type) out.type = find_test_type(label.text);
  const RowCourse course = find_course(out.table, out.meaning);
  out.is_reversed = course.is_reversed;
  out.test_begins = course.test_begins;
  out.test_column = course.test_column;
  if (out.test_begins.size() > 1 || out.is_reversed) {
    const std::size_t rows =
        out.test_begins.size() > 1 ? out.test_begins[1] : out.table.row_lines.size();
    for (TableColumn& column : out.table.columns) {
      column.sample.values = evenly(std::span(column.all).first(rows));
      if (out.is_reversed) std::ranges::reverse(column.sample.values);
    }
    decide_meaning(out);
  }
  out.questions = find_questions(out);
  return out;
}

}  // namespace

const LabelValue* Proposal::label(std::string_view name) const {
  for (const LabelValue& one : labels)
    if ((one.name == name || one.metadata == name) && !one.is_ambiguous) return &one;
  return nullptr;
}

std::vector<Proposal> propose(ByteSource& source) {
  const TableSample sample = read_sample(source);
  const TableStructure structure = structure_of(sample, source);
  const std::size_t blocks = structure.blocks.size();
  if (blocks == 0) return {propose_block(sample, structure, 0)};
  std::vector<Proposal> out;
  for (std::size_t block = 1; block <= blocks; ++block)
    out.push_back(propose_block(sample, structure, block));
  return out;
}

Proposal propose(ByteSource& source, std::size_t block) {
  const TableSample sample = read_sample(source);
  return propose_block(sample, structure_of(sample, source), block);
}

}  // namespace triax::lab
