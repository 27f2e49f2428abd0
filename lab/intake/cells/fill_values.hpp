// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cells that hold no value: texts and numbers of lexicon/fill_values.toml.
#include <string_view>

namespace triax::lab {

/// True if a trimmed cell is a text for "no value": "", "-", "NaN", "n/a", "k.A.", "OVLD", "*****",
/// "1.#QNAN", "#DIV/0!" and other error words of spreadsheets, "<0.1". Letter case does not count.
bool is_fill_text(std::string_view cell);

/// True if a line is a comment by its mark; a first cell of "#DIV/0!" is no mark "#". False for an
/// empty mark.
bool begins_with_comment(std::string_view line, std::string_view mark);

/// True if `number`, as it is printed in the file, is a code for "no value": -9999, -999.25, 9999,
/// 7999, ends of the range of integers, and anything from 1e15 on (1e30, 9.9E37 and 9.91E37 of
/// SCPI, the largest float), which no channel reaches in any unit.
bool is_fill_number(double number);

/// True if a cell with that code means "no value". `previous` is the last value of its column, NaN
/// if there is none: a channel that passes through 9999 by its own motion was within 5 % of it one
/// reading before. Units do not matter, both numbers are as printed.
bool means_no_value(double number, double previous);

/// The quick answer for most cells: false if the number can be no code.
inline bool may_be_fill_number(double number) { return number <= -999 || number >= 6999; }

}  // namespace triax::lab
