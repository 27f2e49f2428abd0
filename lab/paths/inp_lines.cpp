// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/inp_lines.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr double kLargestNumber = 1e60;  // so that products of a few stay finite

}  // namespace

std::optional<double> fortran_number(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c == 'd' || c == 'D') c = 'e';
  if (text.starts_with('+') && !text.starts_with("+-")) text.erase(0, 1);
  const auto value = whole_text_as<double>(text);
  return value && std::abs(*value) <= kLargestNumber ? value : std::nullopt;
}

std::vector<std::string> inp_words(std::string_view line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line) {
    if (c != ' ' && c != '\t' && c != ',' && c != '\r') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

std::string inp_before(std::string_view line, std::string_view marks) {
  return std::string(trimmed(line.substr(0, line.find_first_of(marks))));
}

InpLines::InpLines(std::string text, std::string name)
    : text_(is_utf8(text) ? std::move(text) : utf8_from_cp1252(text)), name_(std::move(name)) {
  if (text_.find('\0') != std::string::npos) throw BadInput(name_, 0, "is not a text file");
}

std::optional<std::string> InpLines::next() {
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view line(text_.data() + at_, end - at_);
    at_ = end + 1;
    ++line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!trimmed(line).empty()) return std::string(line);
  }
  return std::nullopt;
}

std::string InpLines::required(std::string_view what) {
  if (auto line = next()) return *line;
  throw BadInput(name_, line_, fmt::format("the file ends where {} should follow", what));
}

std::vector<double> InpLines::numbers(std::size_t count, std::string_view what) {
  const std::vector<std::string> words = inp_words(required(what));
  std::vector<double> values;
  for (const std::string& word : words) {
    if (values.size() == count) break;
    const auto value = fortran_number(word);
    if (!value) fail(fmt::format("{} is not a number; expected {}", excerpt(word), what));
    values.push_back(*value);
  }
  if (values.size() < count)
    fail(fmt::format("{} of {} numbers; expected {}", values.size(), count, what));
  return values;
}

int InpLines::as_whole(double value, std::string_view what, int lowest, int highest) const {
  if (value != std::floor(value) || value < lowest || value > highest)
    fail(fmt::format("{} is {}; must be an integer from {} to {}", what, value, lowest, highest));
  return static_cast<int>(value);
}

int InpLines::whole(std::string_view what, int lowest, int highest) {
  return as_whole(numbers(1, what)[0], what, lowest, highest);
}

void InpLines::fail(const std::string& message) const { throw BadInput(name_, line_, message); }

}  // namespace triax::lab
