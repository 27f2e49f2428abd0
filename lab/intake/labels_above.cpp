// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/labels_above.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>

#include "lab/base/text.hpp"
#include "lab/intake/names/label_text.hpp"
#include "lab/intake/text/row_model.hpp"
#include "lab/results/test_type.hpp"

namespace triax::lab {
namespace {

using Lines = std::vector<std::vector<std::string>>;

Lines cells_of_lines(const std::vector<std::string>& lines, Separator separator) {
  const Separator between = separator == Separator::blanks ? Separator::wide_blanks : separator;
  Lines cells;
  for (const std::string& line : lines) {
    cells.emplace_back();
    for (const std::string_view cell : cells_of(line, between)) cells.back().emplace_back(cell);
  }
  return cells;
}

void settle_repeated(std::vector<LabelValue>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!labels[i].value) continue;
    for (std::size_t k = i + 1; k < labels.size();) {
      const bool is_same = labels[k].name == labels[i].name && labels[k].value;
      if (is_same && !labels[i].is_ambiguous && !labels[k].is_ambiguous &&
          are_repeated(*labels[i].value, *labels[k].value)) {
        labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(k));
        continue;
      }
      if (is_same) labels[i].is_ambiguous = labels[k].is_ambiguous = true;
      ++k;
    }
  }
}

const LabelValue* find_value(const std::vector<LabelValue>& labels, std::string_view name) {
  const auto found = std::ranges::find(labels, name, &LabelValue::name);
  if (found == labels.end() || !found->value || found->is_ambiguous) return nullptr;
  return &*found;
}

void add_diameter(std::vector<LabelValue>& labels) {
  if (std::ranges::find(labels, "diameter", &LabelValue::name) != labels.end()) return;
  const LabelValue* from = find_value(labels, "area");
  double area_mm2 = 0;
  if (from) {
    area_mm2 = *from->value;
  } else {
    from = find_value(labels, "volume");
    const LabelValue* const height = find_value(labels, "height");
    if (!from || !height) return;
    area_mm2 = *from->value / *height->value;
  }
  const double diameter_mm = std::sqrt(4 / std::numbers::pi * area_mm2);
  if (!std::isfinite(diameter_mm) || diameter_mm <= 0 || !from->is_usual) return;
  labels.push_back({.name = "diameter",
                    .metadata = "specimen.diameter_mm",
                    .text = from->text,
                    .value = diameter_mm,
                    .unit = "mm",
                    .line = from->line,
                    .cell = from->cell});
}

void add_type_of_title(const Lines& lines, std::vector<LabelValue>& labels) {
  if (std::ranges::find(labels, "programme", &LabelValue::name) != labels.end()) return;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const TestType* const type = find_type_in_title(joined(lines[i], " "));
    if (!type) continue;
    labels.push_back({.name = "programme",
                      .metadata = "test.programme",
                      .text = type->codes.front(),
                      .value = {},
                      .unit = {},
                      .line = static_cast<std::int64_t>(i) + 1});
    return;
  }
}

void add_labels_beside(const Lines& beside, std::vector<LabelValue>& labels) {
  std::vector<LabelValue> more = find_labels(beside);
  std::erase_if(more, [&](const LabelValue& label) {
    return std::ranges::find(labels, label.name, &LabelValue::name) != labels.end();
  });
  for (LabelValue& label : more) label.line = 0;
  std::ranges::move(more, std::back_inserter(labels));
}

std::vector<LabelValue> completed(std::vector<LabelValue> labels, const Lines& lines,
                                  const Lines& beside) {
  add_labels_beside(beside, labels);
  settle_repeated(labels);
  add_diameter(labels);
  add_type_of_title(lines, labels);
  const auto in_sheet = labels.size();
  add_type_of_title(beside, labels);
  if (labels.size() > in_sheet) labels.back().line = 0;
  return labels;
}

/// Leaves the labels of one block, and those that are common to all.
void keep_block(std::vector<LabelValue>& labels, const std::vector<TableBlock>& blocks,
                std::size_t number) {
  const auto block_of = [&](const LabelValue& label) {
    std::size_t block = 1;
    while (block < blocks.size() && blocks[block].first_cell <= label.cell) ++block;
    return block;
  };
  const std::vector<LabelValue> all = labels;
  std::erase_if(labels, [&](const LabelValue& label) {
    const std::size_t block = block_of(label);
    const bool is_common = block == 1 && std::ranges::none_of(all, [&](const LabelValue& other) {
                             return other.name == label.name && block_of(other) > 1;
                           });
    return block != number && !is_common;
  });
}

}  // namespace

std::vector<LabelValue> labels_above(const std::vector<std::string>& lines, Separator separator,
                                     const std::vector<std::string>& beside) {
  const Lines cells = cells_of_lines(lines, separator);
  return completed(find_labels(cells), cells, cells_of_lines(beside, Separator::comma));
}

std::vector<LabelValue> labels_above(const TableStructure& structure, std::size_t block) {
  const Lines cells = cells_of_lines(structure.preamble, structure.separator);
  std::vector<LabelValue> labels = find_labels(cells);
  if (block > 0) {
    keep_block(labels, structure.blocks, block);
    if (!structure.heading_lines.empty())
      std::ranges::move(
          find_labels({{structure.blocks[block - 1].title}}, structure.heading_lines.front()),
          std::back_inserter(labels));
  }
  return completed(std::move(labels), cells, cells_of_lines(structure.beside, Separator::comma));
}

}  // namespace triax::lab
