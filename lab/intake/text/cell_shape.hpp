// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The shape of a cell, before anything is known about its table.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lab/records/cells/cells.hpp"

namespace triax::lab {

/// How a file writes numbers.
struct NumberFormat {
  DecimalMark decimal = DecimalMark::point;
  /// Mark between groups of three digits, 0 if there is none. ' ' also means a no-break space.
  char thousands = 0;
};

/// All formats that are known, those without a thousands mark first.
inline constexpr std::array kNumberFormats{
    NumberFormat{DecimalMark::point, 0},    NumberFormat{DecimalMark::comma, 0},
    NumberFormat{DecimalMark::point, ','},  NumberFormat{DecimalMark::comma, '.'},
    NumberFormat{DecimalMark::point, ' '},  NumberFormat{DecimalMark::comma, ' '},
    NumberFormat{DecimalMark::point, '\''}, NumberFormat{DecimalMark::comma, '\''}};

enum class CellShape : std::uint8_t {
  empty,
  number,
  clock,  ///< date, time of day, elapsed time, or a date with a time
  fill,   ///< word for a value that is missing: "NaN", "-", "OVRFLO", "#N/A"
  rule,   ///< drawn line: "-----", "====="
  text,
};

struct ShapedCell {
  CellShape shape = CellShape::empty;
  std::uint8_t formats = 0;  ///< of a number: bit i is set if it can be read in kNumberFormats[i]
};

/// Shape of a cell in UTF-8, without spaces and quotes around it. Accepts minus signs and digits of
/// Unicode, exponents with E or D, and brackets for a negative number.
ShapedCell find_shape(std::string_view cell);

/// True for cells that a row of readings can hold in a column of values.
constexpr bool is_value(CellShape shape) {
  return shape == CellShape::number || shape == CellShape::clock || shape == CellShape::fill;
}

}  // namespace triax::lab
