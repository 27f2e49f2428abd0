// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/record_head.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/column_plan.hpp"
#include "lab/records/metadata.hpp"
#include "lab/results/test_type.hpp"

namespace triax::lab {
namespace {

std::string without_colon(std::string_view label) {
  label = trimmed(label);
  while (label.ends_with(':')) label = trimmed(label.substr(0, label.size() - 1));
  return std::string(label);
}

// "specimen.height_mm" for a label that says cm becomes "specimen.height_cm".
std::string key_in_unit(const std::string& key, const std::string& label) {
  const auto unit = split_heading(label).unit;
  const auto named = split_unit(key);
  if (!unit || !named || named->unit.dimension == sim::Dimension::none) return key;
  const auto found = sim::find_unit(*unit);
  if (!found || found->dimension != named->unit.dimension) return key;
  return fmt::format("{}_{}", named->name, *unit);
}

// A plain number as a laboratory types it, with the decimal mark of its country.
std::string number_text(std::string_view cell) {
  DecimalMark mark = DecimalMark::open;
  double value = 0;
  if (parse_cell(cell, mark, value) == CellKind::number) return fmt::format("{}", value);
  return std::string(cell);
}

void take_label(RecordHeader& header, const TableLayout& layout, std::size_t line,
                const std::vector<std::string_view>& cells, std::size_t cell, const DialectKey& key,
                Findings& findings) {
  const auto label = without_colon(cells[cell]);
  const bool known = std::ranges::any_of(key.labels, [&](const auto& name) {
    return matches_name(label, without_colon(name)) ||
           matches_name(split_heading(label).name, without_colon(name));
  });
  if (!known) return;
  const auto value = std::find_if(cells.begin() + static_cast<std::ptrdiff_t>(cell) + 1,
                                  cells.end(), [](auto text) { return !text.empty(); });
  if (value == cells.end()) return;
  const auto number = static_cast<std::int64_t>(line) + 1;
  const bool text =
      key.key.ends_with("material") || (key.key.starts_with("test.") && !split_unit(key.key));
  try {
    set_metadata(header, fmt::format("{}:{}", layout.file, number), key_in_unit(key.key, label),
                 text ? std::string(*value) : number_text(*value));
  } catch (const BadInput&) {
    findings.note("preamble " + key.key, number,
                  fmt::format("{} = {} is not valid for {} and ignored", excerpt(label),
                              excerpt(*value), key.key));
  }
}

/// All cells of a line of the preamble: the first is its label where others follow.
void keep_line(RecordHeader& header, const std::vector<std::string_view>& cells) {
  constexpr std::size_t kLongest = 500;
  std::vector<std::string> texts;
  for (const auto cell : cells)
    if (!trimmed(cell).empty()) texts.push_back(without_colon(cell).substr(0, kLongest));
  if (texts.empty()) return;
  Note note;
  if (const auto colon = texts[0].find(": "); texts.size() == 1 && colon != std::string::npos)
    note = {texts[0].substr(0, colon), std::string(trimmed(texts[0].substr(colon + 2)))};
  else if (texts.size() == 1)
    note.text = texts[0];
  else
    note = {texts[0], joined({texts.begin() + 1, texts.end()}, ", ")};
  header.notes.push_back(std::move(note));
}

/// A held cell pressure counts where no column has it. One that is not above the back pressure is
/// the effective stress.
bool is_of_use(const LabelValue& label, const RecordHeader& header, const TableLayout& layout) {
  if (label.name != "cell_pressure") return true;
  if (header.has(Quantity::cell_pressure) || header.has(Quantity::radial_stress)) return false;
  return std::ranges::none_of(layout.labels, [&](const LabelValue& other) {
    return other.name == "back_pressure" && other.value && label.value &&
           *other.value >= *label.value;
  });
}

/// A dimension that a result would depend on is not dropped without a word.
void note_unused_label(const LabelValue& label, Findings& findings) {
  if (!label.value) return;
  const std::string text = fmt::format("{} = {:.6g}", label.name, *label.value);
  if (!label.metadata.empty())
    findings.note("label " + label.name, label.line,
                  fmt::format("{} is not used: the lines above the table also have another value "
                              "or meaning; give --set {}=...",
                              text, label.metadata));
  else if (label.name.starts_with("consolidated_"))
    findings.note("label " + label.name, label.line,
                  fmt::format("{} {} is not used: the area at the start of shear is that as built, "
                              "changed by the measured volume and height",
                              text,
                              label.name.ends_with("diameter") ? "mm"
                              : label.name.ends_with("area")   ? "mm2"
                                                               : "mm3"));
}

/// Labels above a table without a dialect.
void set_labels(RecordHeader& header, const TableLayout& layout, Findings& findings) {
  for (const LabelValue& label : layout.labels) {
    if (label.is_ambiguous || label.metadata.empty()) {
      note_unused_label(label, findings);
      continue;
    }
    if (!is_of_use(label, header, layout)) continue;
    const auto where = fmt::format("{}:{}", layout.file, label.line);
    const auto value = label.value ? fmt::format("{:.12g}", *label.value) : label.text;
    try {
      set_metadata(header, where, label.metadata, value);
      findings.note(
          "label " + label.metadata, label.line,
          fmt::format("{} = {} is from {}", label.metadata, value,
                      label.line > 0 ? "the lines above the table" : "another worksheet"));
    } catch (const BadInput&) {
      findings.note(
          "label " + label.metadata, label.line,
          fmt::format("{} is not valid for {} and ignored", excerpt(value), label.metadata));
    }
  }
}

}  // namespace

void describe_record(RecordHeader& header, const TableLayout& layout, Findings& findings) {
  header.source = layout.file;
  header.name = std::filesystem::path(layout.file).stem().string();
  if (!layout.test.empty()) header.name += ", " + layout.test;
  header.dialect = layout.dialect.name;
  header.programme = layout.dialect.programme;
  header.cell_pressure_pa = layout.dialect.cell_pressure_pa;
  header.columns = layout.quantities();
  header.has_time = layout.has(ColumnRole::time) || layout.has(ColumnRole::stage_time);
  std::vector<std::string_view> cells;
  for (std::size_t line = 0; line < layout.head.size(); ++line) {
    split_cells(layout.head[line], layout.heading_separator, cells);
    if (!layout.dialect.comment_is_toml) keep_line(header, cells);
    for (std::size_t cell = 0; cell + 1 < cells.size(); ++cell)
      for (const DialectKey& key : layout.dialect.keys)
        take_label(header, layout, line, cells, cell, key, findings);
  }
  set_labels(header, layout, findings);
  for (const DialectKey& key : layout.dialect.keys)
    if (!key.value.empty())
      set_metadata(header, "dialect " + layout.dialect.name, key.key, key.value);
  if (!header.has_time)
    findings.note("no time", layout.heading_line,
                  "no time column: rates and derivatives are with respect to the axial strain");
}

std::string toml_preamble(const TableLayout& layout) {
  const auto& mark = layout.dialect.comment;
  if (!layout.dialect.comment_is_toml) return {};
  std::string toml;
  bool any = false;
  for (const std::string& line : layout.head) {
    if (line.starts_with(mark)) {
      std::string_view text = line;
      text.remove_prefix(mark.size());
      if (text.starts_with(' ')) text.remove_prefix(1);
      any = any || !trimmed(text).empty();
      toml += text;
    }
    toml += '\n';
  }
  return any ? toml : std::string();
}

StageInfo single_stage(const TableLayout& layout, std::string_view programme) {
  StageInfo stage = layout.dialect.stage;
  stage.number = 1;
  if (stage.drainage != Drainage::unknown) return stage;
  const TestType* type = find_test_type(programme);
  const auto columns = layout.quantities();
  const auto has = [&](Quantity q) { return std::ranges::find(columns, q) != columns.end(); };
  const bool has_pore_pressure =
      has(Quantity::pore_pressure) || has(Quantity::excess_pore_pressure);
  const bool named = type != nullptr;
  if (!named && (!layout.dialect.drainage_from_columns || has(Quantity::back_volume))) return stage;
  const bool drained = named ? type->drained : has(Quantity::volumetric_strain);
  if (named || drained || has_pore_pressure)
    stage.drainage = drained ? Drainage::open : Drainage::closed;
  return stage;
}

}  // namespace triax::lab
