// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A dialect says how one kind of file holds a record: a small TOML, data and not code
// (docs/reference/foreign-tables.md lists its keys). The ones in lab/records/dialects ship with
// triax.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/intake/cells/clock_format.hpp"
#include "lab/records/cells/cells.hpp"
#include "lab/records/row_completion.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// The role of a column that is no quantity. A date and a time of day are one time.
enum class ColumnRole {
  quantity,
  time,
  stage_time,
  stage,
  date,
  time_of_day,
  source,
  test  ///< names the test or the specimen of a row
};

struct DialectColumn {
  ColumnRole role = ColumnRole::quantity;
  Quantity quantity{};       ///< for ColumnRole::quantity
  SourceQuantity source{};   ///< for ColumnRole::source
  std::size_t position = 0;  ///< in a row, from 1; 0: found by its names
  std::vector<std::string>
      names;              ///< synonyms, first choice first; a trailing * stands for anything
  std::string unit;       ///< where the file does not say
  std::string true_unit;  ///< whatever the file says
  double sign = 1;        ///< -1 where the file counts the other way
  double factor = 1;      ///< the value is that of the file times this (proving ring, dial)
  std::optional<DateOrder> date_order;  ///< of a time or date; empty: found from the cells
};

/// A metadata key with the labels under which the preamble has it, or with its value.
struct DialectKey {
  std::string key;  ///< "specimen.height_mm"
  std::vector<std::string> labels;
  std::string value{};  ///< as set_metadata() takes it; empty: by the labels
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
  char thousands = 0;     ///< mark between groups of three digits; 0: none
  std::string encoding;   ///< of a text file; empty: it is found (lab/intake/text/encoding.hpp)
  std::size_t block = 0;  ///< of tables side by side, from 1; 0: the only one
  std::string sheet;      ///< of a workbook; empty: the first that fits
  std::string comment;    ///< lines that begin so are no rows
  bool comment_is_toml = false;  ///< and hold the metadata as TOML
  bool missing_words = true;     ///< NaN, NA, - and the like mean a missing value, as "" does
  std::vector<DialectColumn> columns;
  std::vector<RowConstant> constants;
  std::vector<DialectKey> keys;
  /// True if a column is found by its place, so that the table is found by its shape.
  bool has_places() const {
    return std::ranges::any_of(columns, [](const DialectColumn& one) { return one.position > 0; });
  }
  std::string programme;
  std::optional<double> cell_pressure_pa;  ///< held, of files without a column of it
  StageInfo stage;                         ///< of a record with one stage
  bool drainage_from_columns = true;       ///< if neither readings nor type of test show it
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
