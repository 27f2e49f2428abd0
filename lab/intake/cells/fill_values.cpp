// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/cells/fill_values.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

#include <QString>

#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMaxFillSize = 40;  ///< bytes

struct FillHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const {
    return std::hash<std::string_view>{}(text);
  }
};

struct FillLists {
  std::unordered_set<std::string, FillHash, std::equal_to<>> words;  ///< folded
  std::vector<std::string> begins, limits;
  std::string repeated;         ///< characters
  std::vector<double> numbers;  ///< in order
  double beyond = 0;

  FillLists() {
    const auto document =
        TomlTable::parse(kFillValues.front().text, std::string(kFillValues.front().name));
    const auto texts = document.required_table("texts");
    for (const char* key : {"marks", "words", "infinite", "overload", "fault"})
      for (const auto& text : texts.texts(key)) {
        const auto word = QString::fromStdString(text);
        for (const QString& form : {word, word.toUpper(), word.toLower()})
          words.insert(folded(form.toStdString()));
      }
    begins = texts.texts("begins");
    limits = texts.texts("limits");
    repeated = joined(texts.texts("repeated"), "");
    const auto table = document.required_table("numbers");
    numbers = table.numbers("values");
    std::ranges::sort(numbers);
    beyond = table.required_number("beyond");
  }
};

const FillLists& fill_lists() {
  static const FillLists lists;
  return lists;
}

}  // namespace

bool is_fill_text(std::string_view cell) {
  if (cell.empty()) return true;
  const FillLists& lists = fill_lists();
  const auto begins_cell = [&](const std::string& text) { return cell.starts_with(text); };
  if (std::ranges::any_of(lists.begins, begins_cell)) return true;
  if (cell.find_first_not_of(cell.front()) == std::string_view::npos &&
      lists.repeated.find(cell.front()) != std::string::npos)
    return true;
  const auto limit = std::ranges::find_if(lists.limits, begins_cell);
  if (limit != lists.limits.end()) {
    const auto number = trimmed(cell.substr(limit->size()));
    return !number.empty() && number.find_first_not_of("+-.,0123456789") == std::string_view::npos;
  }
  return cell.size() <= kMaxFillSize && lists.words.contains(folded(cell));
}

bool begins_with_comment(std::string_view line, std::string_view mark) {
  if (mark.empty() || !line.starts_with(mark)) return false;
  const std::string_view cell = line.substr(0, line.find_first_of(",;|\t \""));
  const bool is_error_word = cell.ends_with('!') || cell.ends_with('?') || cell == "#N/A" ||
                             cell == "#N/D" || cell == "#NV";
  return !(is_error_word && is_fill_text(cell));
}

bool is_fill_number(double number) {
  if (!may_be_fill_number(number)) return false;
  const FillLists& lists = fill_lists();
  return std::fabs(number) >= lists.beyond || std::ranges::binary_search(lists.numbers, number);
}

bool means_no_value(double number, double previous) {
  constexpr double kMotion = 0.05;  // of the code: step between two readings of a live channel
  return is_fill_number(number) && !(std::fabs(number - previous) <= kMotion * std::fabs(number));
}

}  // namespace triax::lab
