// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/number_rows.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "lab/records/cells/cells.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kLookedAt_bytes = 1U << 16U;
constexpr int kMinRows = 3, kMinNumbers = 2;

std::string first_bytes(ByteSource& source) {
  source.rewind();
  std::string bytes(kLookedAt_bytes, '\0');
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const auto count = source.read({bytes.data() + filled, bytes.size() - filled});
    if (count == 0) break;
    filled += count;
  }
  source.rewind();
  bytes.resize(filled);
  // Text of two bytes a character has every other one zero: without these it is as good as ASCII.
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    bytes.erase(0, 2);
    std::erase(bytes, '\0');
  }
  return bytes;
}

int count_numbers(std::string_view line) {
  int numbers = 0;
  while (!line.empty()) {
    const auto end = std::min(line.find_first_of(" \t;,|\r"), line.size());
    DecimalMark mark = DecimalMark::open;
    double value = 0;
    if (end > 0 && parse_cell(line.substr(0, end), mark, value) == CellKind::number) ++numbers;
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return numbers;
}

}  // namespace

bool looks_like_readings(ByteSource& source) {
  const std::string bytes = first_bytes(source);
  if (bytes.starts_with("PK\3\4") || bytes.starts_with("\xD0\xCF\x11\xE0")) return true;
  if (bytes.find('\0') != std::string::npos) return false;
  int rows = 0;
  for (std::string_view rest = bytes; !rest.empty() && rows < kMinRows;) {
    const auto end = std::min(rest.find('\n'), rest.size());
    rows = count_numbers(rest.substr(0, end)) >= kMinNumbers ? rows + 1 : 0;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return rows >= kMinRows;
}

}  // namespace triax::lab
