// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/cells.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

#include "lab/base/text.hpp"
#include "lab/intake/cells/fill_values.hpp"

namespace triax::lab {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// One past the end of the blank-separated cell that starts at `i`.
std::size_t blank_cell_end(std::string_view line, std::size_t i, bool wide) {
  if (line[i] == '"') {
    const auto quote = line.find('"', i + 1);
    return quote == std::string_view::npos ? line.size() : quote + 1;
  }
  for (; i < line.size(); ++i) {
    if (line[i] == '\t') return i;
    if (line[i] != ' ') continue;
    if (!wide || i + 1 >= line.size() || is_blank(line[i + 1])) return i;
  }
  return line.size();
}

std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

void split_at_blanks(std::string_view line, bool wide, std::vector<std::string_view>& cells) {
  std::size_t i = 0;
  while (true) {
    while (i < line.size() && is_blank(line[i])) ++i;
    if (i >= line.size()) return;
    const auto end = std::max(blank_cell_end(line, i, wide), i + 1);
    cells.push_back(unquoted(line.substr(i, end - i)));
    i = end;
  }
}

CellKind parse_number_text(std::string_view text, double& value) {
  const bool two_signs = text.starts_with("+-");
  if (text.starts_with('+') && !two_signs) text.remove_prefix(1);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return CellKind::text;
  // Words for infinite values and for none are not numbers.
  if (error == std::errc{} && !std::isfinite(value)) return CellKind::text;
  return error == std::errc{} ? CellKind::number : CellKind::out_of_range;
}

CellKind parse_with_mark(std::string_view cell, DecimalMark& mark, double& value) {
  const auto at = cell.find_first_of(".,");
  if (at == std::string_view::npos) return parse_number_text(cell, value);
  const auto used = mark == DecimalMark::open ? static_cast<DecimalMark>(cell[at]) : mark;
  if (cell[at] != static_cast<char>(used)) return CellKind::text;
  constexpr std::size_t kMaxNumberSize = 64;
  std::array<char, kMaxNumberSize> copy{};
  if (used == DecimalMark::comma) {
    if (cell.size() > kMaxNumberSize) return CellKind::text;
    std::copy(cell.begin(), cell.end(), copy.begin());
    copy[at] = '.';
    cell = {copy.data(), cell.size()};
  }
  const auto kind = parse_number_text(cell, value);
  if (kind != CellKind::text) mark = used;
  return kind;
}

}  // namespace

const char* separator_name(Separator separator) {
  switch (separator) {
    case Separator::automatic:
      return "auto";
    case Separator::comma:
      return "comma";
    case Separator::semicolon:
      return "semicolon";
    case Separator::tab:
      return "tab";
    case Separator::blanks:
      return "blanks";
    case Separator::wide_blanks:
      return "wide blanks";
    case Separator::pipe:
      return "pipe";
  }
  return "";
}

char character(Separator separator) {
  switch (separator) {
    case Separator::comma:
      return ',';
    case Separator::semicolon:
      return ';';
    case Separator::tab:
      return '\t';
    case Separator::pipe:
      return '|';
    default:
      return 0;
  }
}

void split_cells(std::string_view line, Separator separator, std::vector<std::string_view>& cells) {
  cells.clear();
  const char mark = character(separator);
  if (mark == 0) {
    split_at_blanks(line, separator == Separator::wide_blanks, cells);
    return;
  }
  std::size_t start = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != mark || quoted) continue;
    cells.push_back(unquoted(line.substr(start, i - start)));
    start = i + 1;
  }
  cells.push_back(unquoted(line.substr(start)));
}

CellKind parse_cell(std::string_view cell, DecimalMark& mark, double& value) {
  const auto kind = cell.empty() ? CellKind::missing : parse_with_mark(cell, mark, value);
  return kind == CellKind::text && is_fill_text(cell) ? CellKind::missing : kind;
}

bool parse_plain(const char*& at, const char* end, double& value) {
  // m·10^-k is the nearest double if m < 2^53 and k <= 22, both exact: one division, one rounding.
  constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                           1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr int kMostDigits = 15;
  const char* p = at;
  const bool negative = p != end && *p == '-';
  if (negative) ++p;
  std::uint64_t mantissa = 0;
  const char* digits = p;
  while (p != end && static_cast<unsigned>(*p - '0') < 10U)
    mantissa = 10 * mantissa + static_cast<unsigned>(*p++ - '0');
  auto count = p - digits;
  std::ptrdiff_t decimals = 0;
  if (p != end && *p == '.') {
    const char* fraction = ++p;
    while (p != end && static_cast<unsigned>(*p - '0') < 10U)
      mantissa = 10 * mantissa + static_cast<unsigned>(*p++ - '0');
    decimals = p - fraction;
    count += decimals;
  }
  if (count == 0 || count > kMostDigits) return false;
  const double magnitude =
      static_cast<double>(mantissa) / kPowers[static_cast<std::size_t>(decimals)];
  value = negative ? -magnitude : magnitude;
  at = p;
  return true;
}

}  // namespace triax::lab
