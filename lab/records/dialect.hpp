// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A dialect says how one kind of file holds a record: a small TOML, data and not code
// (docs/reference/record-files.md lists its keys). The ones in lab/records/dialects ship with
// triax.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/records/cells/cells.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// What a column holds, beside the quantities.
enum class ColumnRole { quantity, time, stage_time, stage };

struct DialectColumn {
  ColumnRole role = ColumnRole::quantity;
  Quantity quantity{};  ///< for ColumnRole::quantity
  std::vector<std::string>
      names;              ///< synonyms, first choice first; a trailing * stands for anything
  std::string unit;       ///< where the file does not say
  std::string true_unit;  ///< whatever the file says
  double sign = 1;        ///< -1 where the file counts the other way
};

/// A metadata key and the labels under which the preamble has it.
struct DialectKey {
  std::string key;  ///< "specimen.height_mm"
  std::vector<std::string> labels;
};

struct Dialect {
  std::string name;
  std::string about;
  std::vector<std::string> headings;  ///< all must stand in the heading line
  std::vector<std::string> contains;  ///< texts that must stand above or in the heading line
  bool own_headings = false;          ///< headings in triax's own form are understood too
  Separator separator = Separator::automatic;
  Separator heading_separator = Separator::automatic;  ///< where the heading line has its own
  DecimalMark decimal = DecimalMark::open;
  std::string sheet;             ///< of a workbook; empty: the first that fits
  std::string comment;           ///< lines that begin so are no rows
  bool comment_is_toml = false;  ///< and hold the metadata as TOML
  bool missing_words = true;     ///< NaN, NA, - and the like mean a missing value, as "" does
  std::vector<DialectColumn> columns;
  std::vector<DialectKey> keys;
  std::string programme;
  StageInfo stage;                    ///< of a record with one stage
  bool drainage_from_columns = true;  ///< judge by the programme's name, then by the columns
};

/// With extends = "NAME" what the file says is added to that shipped dialect, or stands in its
/// place: columns and keys one by one, everything else where it is said. Throws BadInput
/// "FILE:LINE: ..." on unknown keys, dialects, quantities, units and separators.
Dialect parse_dialect(std::string_view toml, const std::string& file);
/// The dialects inside the program, our own first.
const std::vector<Dialect>& shipped_dialects();
/// A shipped dialect's name, or a path that ends in .toml. BadInput lists the names there are.
Dialect find_dialect(const std::string& name_or_file);

/// True where a heading (without its unit) is one of the dialect's names for it.
bool matches_name(std::string_view heading, std::string_view name);
/// False where the first letters already differ: heading and name are then no match with or without
/// a unit. Cheap, for the search over every cell of a long preamble.
bool may_match(std::string_view heading, std::string_view name);

}  // namespace triax::lab
