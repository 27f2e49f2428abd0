// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_line.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

std::size_t behind_blanks(std::string_view line, std::size_t i) {
  while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
  return i;
}

/// The text from behind the opening quote at `i`, which moves behind the closing one; false where
/// there is none.
bool take_quoted(std::string_view line, std::size_t& i, std::string& text) {
  for (++i; i < line.size(); ++i) {
    if (line[i] != '"') {
      text.push_back(line[i]);
    } else if (i + 1 < line.size() && line[i + 1] == '"') {
      text.push_back('"');
      ++i;
    } else {
      ++i;
      return true;
    }
  }
  return false;
}

}  // namespace

std::string split_ags_line(std::string_view line, std::vector<std::string>& cells) {
  cells.clear();
  for (std::size_t i = 0;; ++i) {
    std::string& text = cells.emplace_back();
    const std::size_t first = behind_blanks(line, i);
    if (first < line.size() && line[first] == '"') {
      i = first;
      if (!take_quoted(line, i, text))
        return fmt::format(
            "the quote of cell {} is not closed; an AGS4 cell cannot contain a line break",
            cells.size());
      i = behind_blanks(line, i);
      if (i < line.size() && line[i] != ',')
        return fmt::format(
            "text after the closing quote of cell {}, {}; write a quote inside a cell twice",
            cells.size(), excerpt(text));
    } else {
      const std::size_t comma = std::min(line.find(',', i), line.size());
      text = trimmed(line.substr(i, comma - i));
      i = comma;
    }
    if (i >= line.size()) return {};
  }
}

}  // namespace triax::lab
