// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/pattern.hpp"

#include <algorithm>
#include <cctype>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {
bool scpi_lower(char c) { return c >= 'a' && c <= 'z'; }
bool scpi_digit(char c) { return c >= '0' && c <= '9'; }
bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::toupper(x) == std::toupper(y); });
}
}  // namespace

ScpiPattern::ScpiPattern(std::string_view pattern)
    : text_(pattern), query_(pattern.ends_with('?')) {
  bool optional = false;
  std::string word;
  const auto end_of_word = [&] {
    if (word.empty()) return;
    const bool numbered = word.ends_with('#');
    if (numbered) word.pop_back();
    std::string shorter = word;
    std::erase_if(shorter, scpi_lower);
    nodes_.push_back({shorter, word, optional, numbered});
    word.clear();
  };
  for (const char c : pattern) {
    if (c == '[' || c == ']' || c == ':' || c == '?') end_of_word();
    if (c == '[' || c == ']')
      optional = c == '[';
    else if (c != ':' && c != '?')
      word += c;
  }
  end_of_word();
}

ScpiPattern::Match ScpiPattern::match(std::string_view header, std::vector<int>& suffixes) const {
  suffixes.clear();
  if (header.ends_with('?') != query_) return Match::no;
  if (query_) header.remove_suffix(1);
  return header.empty() ? Match::no : match_from(0, header, suffixes);
}

ScpiPattern::Match ScpiPattern::match_from(std::size_t node, std::string_view rest,
                                           std::vector<int>& suffixes) const {
  if (node == nodes_.size()) return rest.empty() ? Match::yes : Match::no;
  const Node& here = nodes_[node];
  const std::size_t known = suffixes.size();
  Match best = Match::no;
  if (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(':'));
    best = match_node(here, word, suffixes);
    if (best != Match::no) {
      const std::string_view after = rest.substr(std::min(rest.size(), word.size() + 1));
      const Match further = match_from(node + 1, after, suffixes);
      if (further == Match::yes && best == Match::yes) return Match::yes;
      if (further == Match::no) best = Match::no;
      if (further == Match::wrong_suffix) best = Match::wrong_suffix;
    }
  }
  if (!here.optional) return best;
  suffixes.resize(known);
  if (here.numbered) suffixes.push_back(1);
  const Match without = match_from(node + 1, rest, suffixes);
  return without == Match::no ? best : without;
}

ScpiPattern::Match ScpiPattern::match_node(const Node& node, std::string_view word,
                                           std::vector<int>& suffixes) {
  std::size_t letters = word.size();
  while (letters > 0 && scpi_digit(word[letters - 1])) --letters;
  const std::string_view digits = word.substr(letters);
  word = word.substr(0, letters);
  if (!same_word(word, node.shorter) && !same_word(word, node.longer)) return Match::no;
  if (digits.empty()) {
    if (node.numbered) suffixes.push_back(1);
    return Match::yes;
  }
  const auto number = whole_text_as<int>(digits);
  if (!node.numbered || !number) return Match::wrong_suffix;
  suffixes.push_back(*number);
  return Match::yes;
}

std::string ScpiPattern::shortest() const {
  std::string text;
  for (const Node& node : nodes_)
    if (!node.optional) text += (text.empty() ? "" : ":") + node.shorter;
  return text + (query_ ? "?" : "");
}

std::string ScpiPattern::longest() const {
  std::string text;
  for (const Node& node : nodes_) text += (text.empty() ? "" : ":") + node.longer;
  return text + (query_ ? "?" : "");
}

}  // namespace triax::lab
