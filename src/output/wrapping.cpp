// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/wrapping.hpp"

#include <algorithm>
#include <sstream>

#include "src/output/table.hpp"

namespace triax::src {
namespace {

bool is_number(const std::string& word) {
  const auto digit = word.find_first_not_of("+-±");
  return digit != std::string::npos && word[digit] >= '0' && word[digit] <= '9';
}

/// What no line break may divide: a number stays with its symbol and its unit, "ε₁ 0.40 %".
std::vector<std::string> unbroken(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream words(text);
  bool after_number = false, after_stop = true;  // what the part so far ends in
  for (std::string word; words >> word;) {
    const bool number = is_number(word);
    if (!after_stop && (number || after_number))
      parts.back() += ' ' + word;
    else
      parts.push_back(word);
    after_number = number;
    after_stop = std::string(",;:.").find(word.back()) != std::string::npos;
  }
  return parts;
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream paragraphs(text);
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    if (display_width(paragraph) <= width) {  // as it is, with all its blanks
      lines.push_back(paragraph);
      continue;
    }
    std::string line;
    for (const std::string& word : unbroken(paragraph)) {
      if (!line.empty() && display_width(line) + 1 + display_width(word) > width) {
        lines.push_back(std::move(line));
        line.clear();
      }
      line += (line.empty() ? "" : " ") + word;
    }
    lines.push_back(std::move(line));
  }
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0;
  for (const auto& word : unbroken(text)) longest = std::max(longest, display_width(word));
  return longest;
}

}  // namespace triax::src
