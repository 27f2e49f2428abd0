// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/test_type.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <utility>

#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMaxText = 1000;  ///< of which a type is looked for

TestType::Consolidation consolidation_from(const TomlTable& table) {
  using enum TestType::Consolidation;
  const auto word = table.required_text("consolidation");
  if (word == "none") return none;
  if (word == "isotropic") return isotropic;
  if (word == "anisotropic") return anisotropic;
  return word == "k0" ? k0 : unknown;
}

TestType read_type(const TomlTable& table) {
  TestType type;
  type.codes = table.texts("codes");
  type.names = table.texts("names");
  for (std::string& name : type.names) name = folded(name);
  type.consolidation = consolidation_from(table);
  type.drained = table.required_text("drainage") == "open";
  if (const auto direction = table.text("direction")) type.extension = *direction == "extension";
  type.multi_stage = table.flag("multi_stage").value_or(false);
  type.cyclic = table.flag("cyclic").value_or(false);
  type.unconfined = table.integer("cell_pressure") == 0;
  type.pore_pressure = table.flag("pore_pressure").value_or(false);
  return type;
}

std::vector<TestType> read_types() {
  std::vector<TestType> all;
  for (const EmbeddedFile& file : kStageWords)
    for (const TomlTable& table :
         TomlTable::parse(file.text, std::string(file.name) + ".toml").tables("test_type"))
      all.push_back(read_type(table));
  return all;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// With subscript digits and letters as plain ones.
std::string without_subscripts(std::string_view text) {
  constexpr std::string_view kZero = "₀", kLetter = "ₒ";
  std::string out;
  while (!text.empty()) {
    const bool zero = text.starts_with(kZero), letter = text.starts_with(kLetter);
    out.push_back(zero ? '0' : letter ? 'o' : text.front());
    text.remove_prefix(zero ? kZero.size() : letter ? kLetter.size() : 1);
  }
  return out;
}

/// Letters and digits in upper case, all else left out; empty for a text beyond ASCII.
std::string code_of(std::string_view text) {
  std::string code;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) >= 0x80) return {};
    if (is_letter_or_digit(c))
      code.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
  }
  return code;
}

using ByCode = std::map<std::string, const TestType*, std::less<>>;

const ByCode& types_by_code() {
  static const ByCode all = [] {
    ByCode found;
    for (const TestType& type : test_types())
      for (const std::string& code : type.codes) found.emplace(code_of(code), &type);
    return found;
  }();
  return all;
}

const TestType* type_of_code(std::string_view code) {
  const auto found = types_by_code().find(code);
  return found == types_by_code().end() ? nullptr : found->second;
}

/// A word of two letters or more, with or without a number behind it: "CIU", "CIU3".
const TestType* type_of_word(std::string_view word) {
  constexpr std::size_t kShortest = 2;
  const auto code = code_of(word);
  if (code.size() < kShortest) return nullptr;
  if (const TestType* type = type_of_code(code)) return type;
  const auto last_letter = code.find_last_not_of("0123456789");
  if (last_letter == std::string::npos || last_letter + 1 < kShortest) return nullptr;
  return type_of_code(code.substr(0, last_letter + 1));
}

const TestType* first_word_with_a_type(std::string_view text) {
  while (!text.empty()) {
    const auto* const from = std::ranges::find_if(text, is_letter_or_digit);
    text.remove_prefix(static_cast<std::size_t>(from - text.begin()));
    const auto* const end = std::ranges::find_if_not(text, is_letter_or_digit);
    const auto size = static_cast<std::size_t>(end - text.begin());
    if (const TestType* type = type_of_word(text.substr(0, size))) return type;
    text.remove_prefix(size);
  }
  return nullptr;
}

const TestType* type_with_the_longest_name(const std::string& text) {
  const TestType* found = nullptr;
  std::size_t longest = 0;
  for (const TestType& type : test_types())
    for (const std::string& name : type.names) {
      if (name.size() <= longest || text.find(name) == std::string::npos) continue;
      longest = name.size();
      found = &type;
    }
  return found;
}

/// Words for a test, folded.
const std::vector<std::string>& title_words() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> words;
    for (const EmbeddedFile& file : kStageWords)
      for (const std::string& word :
           TomlTable::parse(file.text, std::string(file.name) + ".toml").texts("title_words"))
        words.push_back(folded(word));
    return words;
  }();
  return all;
}

bool is_title_word(std::string_view word) {
  const std::string plain = folded(word);
  return std::ranges::any_of(title_words(),
                             [&](const std::string& known) { return plain.starts_with(known); });
}

bool is_in_capitals(std::string_view word) {
  return std::ranges::count_if(word, [](char c) { return c >= 'A' && c <= 'Z'; }) > 1;
}

struct TitleCodes {
  /// In front of a word for a test, or behind one and at the end or in front of a number.
  std::vector<const TestType*> beside_words;
  std::vector<const TestType*> all;
};

/// Types by codes in capitals.
TitleCodes find_title_codes(std::string_view title) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < title.size();) {
    const std::size_t end = std::min(title.find_first_of(" ,;()/\t", at), title.size());
    if (end > at) words.emplace_back(title.substr(at, end - at));
    at = end + 1;
  }
  TitleCodes found;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const TestType* const type = is_in_capitals(words[i]) ? type_of_word(words[i]) : nullptr;
    if (!type) continue;
    found.all.push_back(type);
    const bool is_last = i + 1 == words.size();
    const bool is_before = !is_last && is_title_word(words[i + 1]);
    const bool is_behind = i > 0 && is_title_word(words[i - 1]);
    if (is_before || (is_behind && (is_last || is_digit(words[i + 1].front()))))
      found.beside_words.push_back(type);
  }
  return found;
}

/// Types by names in words that are in no longer name of another one.
std::vector<const TestType*> types_by_longest_names(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> places;  // first and last character
  std::vector<const TestType*> types;
  for (const TestType& type : test_types())
    for (const std::string& name : type.names)
      if (const auto at = text.find(name); at != std::string::npos) {
        places.emplace_back(at, at + name.size());
        types.push_back(&type);
      }
  std::vector<const TestType*> found;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_inside = std::ranges::any_of(places, [&](const auto& other) {
      return other.first <= places[i].first && places[i].second <= other.second &&
             other != places[i];
    });
    if (!is_inside) found.push_back(types[i]);
  }
  return found;
}

}  // namespace

const std::vector<TestType>& test_types() {
  static const std::vector<TestType> all = read_types();
  return all;
}

const TestType* find_test_type(std::string_view text) {
  const auto plain = without_subscripts(text.substr(0, kMaxText));
  if (const TestType* type = type_of_code(code_of(plain))) return type;
  if (const TestType* type = type_with_the_longest_name(folded(plain))) return type;
  return first_word_with_a_type(plain);
}

const TestType* find_type_in_title(std::string_view title) {
  const auto plain = without_subscripts(trimmed(title.substr(0, kMaxText)));
  if (is_in_capitals(plain))
    if (const TestType* type = type_of_code(code_of(plain))) return type;
  auto found = types_by_longest_names(folded(plain));
  const TitleCodes codes = find_title_codes(plain);
  std::ranges::copy(codes.beside_words, std::back_inserter(found));
  const auto agrees = [&](const TestType* type) {
    return type->drained == found.front()->drained &&
           type->is_total_stress() == found.front()->is_total_stress() &&
           type->unconfined == found.front()->unconfined;
  };
  if (found.empty() || !std::ranges::all_of(found, agrees) ||
      !std::ranges::all_of(codes.all, agrees))
    return nullptr;
  // The most specific one: "CIU" beside "consolidated undrained".
  const auto detail = [](const TestType* type) {
    return (type->consolidation != TestType::Consolidation::unknown ? 1 : 0) +
           (type->extension ? 1 : 0) + (type->multi_stage ? 1 : 0) + (type->cyclic ? 1 : 0);
  };
  return *std::ranges::max_element(found, {}, detail);
}

}  // namespace triax::lab
