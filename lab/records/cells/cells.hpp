// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One line as cells, one cell as a number: the two things that every table of readings needs.
#include <string_view>
#include <vector>

namespace triax::lab {

/// How cells are kept apart.
enum class Separator {
  automatic,
  comma,
  semicolon,
  tab,
  blanks,       ///< runs of blanks and tabs
  wide_blanks,  ///< runs of two or more blanks, or a tab: names may hold single blanks
  pipe,
};

/// Name of a separator as dialects and messages write it: "comma", "wide blanks", "auto".
const char* separator_name(Separator separator);

/// The character between cells, 0 for the kinds that have none of their own.
char character(Separator separator);

/// Splits a line. Cells may stand in double quotes; a quote inside is doubled. Cells come without
/// surrounding blanks and quotes and point into `line`, except that a doubled quote stays doubled.
void split_cells(std::string_view line, Separator separator, std::vector<std::string_view>& cells);

/// `out_of_range` is a number that no double is near to: 1e400, and 1e-400, which is not 0.
enum class CellKind { number, missing, out_of_range, text };

/// Which decimal mark a table uses; open until the first one is met.
enum class DecimalMark : char { open = 0, point = '.', comma = ',' };

/// A trimmed cell as a number, by the marks of `mark` (which the first number with a mark sets).
/// Texts for "no value" (lab/intake/cells/fill_values.hpp) are missing; a dialect may still refuse
/// all but "". `value` is set for CellKind::number only.
CellKind parse_cell(std::string_view cell, DecimalMark& mark, double& value);

/// Plain decimal number at `at` ("-12.345") as the nearest double, by the shortest way; moves `at`
/// behind it. False, with `at` unmoved, for anything else (exponent, many digits, text).
bool parse_plain(const char*& at, const char* end, double& value);

}  // namespace triax::lab
