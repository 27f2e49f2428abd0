// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Labels above a table: "Initial Height (mm)","76" or "H0 = 76 mm; D0 = 38 mm".
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace triax::lab {

/// A value that a label names. The labels are in lab/intake/lexicon/labels.toml.
struct LabelValue {
  std::string name;      ///< of the label: "height"
  std::string metadata;  ///< key of triax that takes the value: "specimen.height_mm", or empty
  std::string text;      ///< the value as written, without its unit
  std::optional<double> value;  ///< in the canonical unit of the label; empty for a text
  std::string unit;             ///< as written; empty: `value` is the number as written
  std::int64_t line = 0;
  std::size_t cell = 0;  ///< of the label in its line, from 0
  bool is_usual = true;  ///< `value` is in the usual range of the label
  /// The same text is also the value of another label, or another line has another value.
  bool is_ambiguous = false;
};

/// Labels with values in the lines above a table, in their order. `lines` are cells (UTF-8), the
/// first of them is line `first_line` of the file. The value is in the next cell with a text,
/// behind a colon, an equals sign or a space, or below a line of labels only; its unit is behind
/// the label, behind the value or in the cell to the right. One text can have several labels. A
/// unit of another dimension, where the label can have one (density for a specific gravity), leaves
/// the number as written. A title above values or above lines with labels ("After consolidation")
/// states to which state of the specimen they belong.
std::vector<LabelValue> find_labels(const std::vector<std::vector<std::string>>& lines,
                                    std::int64_t first_line = 1);

}  // namespace triax::lab
