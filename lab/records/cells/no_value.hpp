// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers that loggers write where they have no value.
#include <cmath>

namespace triax::lab {

/// True if `number`, as it is printed in the file, is a code for "no value": -9999, -999, -999.25
/// and other negative nines; 9999, 99999 and longer; 6999 and 7999 of either sign (range exceeded,
/// not a number, in loggers of 16 bits); -8888 and -7777; the ends of integers of 16 and 32 bits;
/// and anything from 1e15 on (1e30, 9.9E37 and 9.91E37 of SCPI, the largest float), which no
/// channel reaches in any unit.
bool is_no_value_code(double number);

/// True if a cell with that code means "no value". `previous` is the last value of its column, NaN
/// if there is none: a channel that passes through 9999 by its own motion was within kMotion of it
/// one reading before. Units do not matter, both numbers are as printed.
bool means_no_value(double number, double previous);

/// The quick answer for most cells: false where the number can be no code.
inline bool may_be_no_value(double number) { return number <= -999 || number >= 6999; }

}  // namespace triax::lab
