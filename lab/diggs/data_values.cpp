// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/data_values.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";

bool is_space(std::string_view separator) {
  return separator.find_first_not_of(kSpaces) == std::string_view::npos;
}

/// Pieces between separators; separators that are spaces leave no empty piece.
template <class Use>
void for_each_piece(std::string_view text, std::string_view separator, const Use& use) {
  const bool spaces = is_space(separator);
  std::size_t at = 0;
  while (at <= text.size()) {
    const auto end =
        std::min(spaces ? text.find_first_of(kSpaces, at) : text.find(separator, at), text.size());
    const auto piece = text.substr(at, end - at);
    if (!spaces || !piece.empty()) use(piece, at);
    at = end + (spaces ? 1 : separator.size());
  }
}

/// Line of a place of the text; places must not go down.
class LineCounter {
 public:
  LineCounter(std::string_view text, std::int64_t line) : text_(text), line_(line) {}
  std::int64_t at(std::size_t place) {
    line_ += std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                        text_.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    at_ = place;
    return line_;
  }

 private:
  std::string_view text_;
  std::int64_t line_;
  std::size_t at_ = 0;
};

/// For cells and tuples that are both separated by spaces: a tuple ends with its last property.
std::vector<DiggsTuple> split_by_count(const DiggsResultSet& set) {
  std::vector<DiggsTuple> tuples;
  LineCounter lines(set.values, set.line);
  for_each_piece(set.values, " ", [&](std::string_view cell, std::size_t place) {
    if (tuples.empty() || tuples.back().cells.size() == set.properties.size())
      tuples.push_back({.line = lines.at(place), .cells = {}});
    tuples.back().cells.push_back(cell);
  });
  return tuples;
}

/// `joins`: a tuple that ends with a separator continues after the spaces ("1, 2, 3").
std::vector<DiggsTuple> split_by_marks(const DiggsResultSet& set, bool joins) {
  std::vector<DiggsTuple> tuples;
  LineCounter lines(set.values, set.line);
  bool goes_on = false;
  for_each_piece(set.values, set.tuple_separator, [&](std::string_view text, std::size_t place) {
    if (trimmed(text).empty() || is_space(text)) return;
    if (goes_on)
      tuples.back().cells.pop_back();
    else
      tuples.push_back({.line = lines.at(place), .cells = {}});
    for_each_piece(text, set.cell_separator, [&](std::string_view cell, std::size_t) {
      tuples.back().cells.push_back(trimmed(cell));
    });
    goes_on = joins && tuples.back().cells.back().empty();
  });
  return tuples;
}

}  // namespace

std::vector<DiggsTuple> split_data_values(const DiggsResultSet& set, const std::string& file) {
  const auto is_wrong = [&](const DiggsTuple& tuple) {
    return tuple.cells.size() != set.properties.size();
  };
  if (set.properties.empty())
    throw BadInput(file, set.line, "dataValues without a Property that names its columns");
  auto tuples = is_space(set.cell_separator) ? split_by_count(set) : split_by_marks(set, false);
  const auto wrong = std::ranges::find_if(tuples, is_wrong);
  if (wrong == tuples.end()) return tuples;
  if (!is_space(set.cell_separator))
    if (auto joined = split_by_marks(set, true); std::ranges::none_of(joined, is_wrong))
      return joined;
  throw BadInput(file, wrong->line,
                 fmt::format("a tuple of dataValues has {} values; the set has {} properties",
                             wrong->cells.size(), set.properties.size()));
}

}  // namespace triax::lab
