// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/number_cell.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace triax::lab {
namespace {

constexpr std::string_view kMinus = "\u2212";
/// No-break spaces between groups of digits.
constexpr std::array<std::string_view, 3> kBlanks{"\u00A0", "\u202F", "\u2009"};
constexpr std::size_t kMaxNumber_bytes = 64;

bool is_plain(std::string_view cell, const NumberFormat& format) {
  return format.thousands == 0 && std::ranges::none_of(cell, [](char c) {
           return static_cast<unsigned char>(c) >= 0x80 || c == '(' || c == 'D' || c == 'd';
         });
}

std::string without_marks(std::string_view cell, char thousands) {
  std::string out;
  for (std::size_t i = 0; i < cell.size();) {
    const auto rest = cell.substr(i);
    const auto* const blank = std::ranges::find_if(
        kBlanks, [&](std::string_view text) { return rest.starts_with(text); });
    if (rest.starts_with(kMinus)) {
      out += '-';
      i += kMinus.size();
    } else if (thousands == ' ' && blank != kBlanks.end()) {
      i += blank->size();
    } else {
      if (thousands == 0 || cell[i] != thousands) out += cell[i];
      ++i;
    }
  }
  return out;
}

}  // namespace

CellKind parse_number_cell(std::string_view cell, const NumberFormat& format, double& value) {
  DecimalMark mark = format.decimal;
  if (cell.size() > kMaxNumber_bytes || is_plain(cell, format))
    return parse_cell(cell, mark, value);
  std::string text = without_marks(cell, format.thousands);
  if (text.size() > 2 && text.front() == '(' && text.back() == ')')
    text = "-" + text.substr(1, text.size() - 2);
  const auto exponent = text.find_first_of("Dd");
  if (exponent != std::string::npos && exponent > 0 && text[exponent - 1] >= '0' &&
      text[exponent - 1] <= '9')
    text[exponent] = 'e';
  const CellKind kind = parse_cell(text, mark, value);
  if (kind == CellKind::number) return kind;
  mark = format.decimal;
  return parse_cell(cell, mark, value);
}

}  // namespace triax::lab
