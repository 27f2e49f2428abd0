// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/test_type.hpp"

#include <algorithm>
#include <cctype>
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

}  // namespace triax::lab
