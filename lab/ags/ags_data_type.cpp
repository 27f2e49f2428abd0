// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_data_type.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

struct CountedType {
  int count = 0;
  std::string_view kind;  ///< "DP", "SF", "SCI"
};

std::optional<CountedType> counted(std::string_view type) {
  for (const std::string_view kind : {"SCI", "DP", "SF"}) {
    if (!type.ends_with(kind)) continue;
    const auto count = whole_text_as<int>(type.substr(0, type.size() - kind.size()));
    if (count && *count >= 0 && *count < 16) return CountedType{*count, kind};
  }
  return std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "yyyy-mm-ddThh:mm" cut to the length of the cell: letters stand for digits but the T.
bool fits_form(std::string_view cell, std::string_view form) {
  if (form.empty() || cell.size() > form.size()) return form.empty();
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const bool letter = std::isalpha(static_cast<unsigned char>(form[i])) != 0 && form[i] != 'T';
    if (letter ? !is_digit(cell[i]) : cell[i] != form[i]) return false;
  }
  return cell.size() == form.size() || form[cell.size()] == '-' || form[cell.size()] == 'T' ||
         form[cell.size()] == ':';
}

bool fits_degrees(std::string_view cell) {
  return !cell.empty() && std::ranges::all_of(cell, [](char c) {
    return is_digit(c) || c == ':' || c == '.' || c == '-';
  });
}

/// So many digits that count, never with an exponent.
std::string significant(double value, int digits) {
  if (value == 0) return "0";
  const std::string rounded = fmt::format("{:.{}e}", value, std::max(digits, 1) - 1);
  const int power = std::stoi(rounded.substr(rounded.find('e') + 1));
  return fmt::format("{:.{}f}", std::stod(rounded), std::max(digits - 1 - power, 0));
}

}  // namespace

std::string ags_number(std::optional<double> value, std::string_view type) {
  if (!value || !std::isfinite(*value)) return {};
  const auto form = counted(type);
  std::string out;
  if (!form)
    out = fmt::format("{}", *value);
  else if (form->kind == "DP")
    out = fmt::format("{:.{}f}", *value, form->count);
  else if (form->kind == "SF")
    out = significant(*value, form->count);
  else
    out = fmt::format("{:.{}e}", *value, form->count);
  const bool zero = out.find_first_of("123456789") == std::string::npos;
  return zero && out.starts_with('-') ? out.substr(1) : out;
}

bool fits_ags_type(std::string_view cell, std::string_view type, std::string_view unit) {
  if (cell.empty()) return true;
  const auto number = whole_text_as<double>(cell);
  const bool finite = number && std::isfinite(*number);
  if (const auto form = counted(type)) {
    if (!finite) return false;
    if (form->kind == "SCI") {
      const auto e = cell.find_first_of("eE");
      const auto point = cell.find('.');
      if (e == std::string_view::npos) return false;
      const auto decimals = point == std::string_view::npos ? 0 : e - point - 1;
      return decimals == static_cast<std::size_t>(form->count);
    }
    if (cell.find_first_of("eE") != std::string_view::npos) return false;
    if (form->kind == "SF") return std::stod(significant(*number, form->count)) == *number;
    const auto point = cell.find('.');
    const auto decimals = point == std::string_view::npos ? 0 : cell.size() - point - 1;
    return decimals == static_cast<std::size_t>(form->count);
  }
  if (type == "U") return finite;
  if (type == "YN")
    return cell == "Y" || cell == "N" || folded(cell) == "yes" || folded(cell) == "no";
  if (type == "DT" || type == "T") return fits_form(cell, unit);
  if (type == "DMS") return fits_degrees(cell);
  return true;
}

}  // namespace triax::lab
