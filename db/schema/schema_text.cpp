// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/schema/schema_text.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace triax::db {
namespace {

using Words = std::vector<std::string>;

bool is_word_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$' || c == '.' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Behind the blanks and comments from `at` on.
std::size_t behind_blanks(std::string_view sql, std::size_t at) {
  for (;;) {
    while (at < sql.size() && std::isspace(static_cast<unsigned char>(sql[at])) != 0) ++at;
    const std::string_view rest = sql.substr(at);
    const std::string_view end = rest.starts_with("--") ? "\n" : rest.starts_with("/*") ? "*/" : "";
    if (end.empty()) return at;
    const auto found = rest.find(end, 2);
    at = found == std::string_view::npos ? sql.size() : at + found + end.size();
  }
}

/// Behind the quoted text that begins at `at`.
std::size_t behind_quoted(std::string_view sql, std::size_t at) {
  const char close = sql[at] == '[' ? ']' : sql[at];
  for (++at; at < sql.size(); ++at) {
    if (sql[at] != close) continue;
    if (close == ']' || at + 1 >= sql.size() || sql[at + 1] != close) return at + 1;
    ++at;
  }
  return at;
}

/// The name in double quotes alone, where that is one word.
std::string without_quotes(std::string_view quoted) {
  if (quoted.size() > 2 && quoted.front() == '"') {
    const std::string_view inner = quoted.substr(1, quoted.size() - 2);
    if (std::ranges::all_of(inner, is_word_letter)) return std::string(inner);
  }
  return std::string(quoted);
}

Words words_of(std::string_view sql) {
  Words words;
  for (std::size_t at = behind_blanks(sql, 0); at < sql.size(); at = behind_blanks(sql, at)) {
    const std::size_t begin = at;
    if (std::string_view("'\"`[").find(sql[at]) != std::string_view::npos) {
      at = behind_quoted(sql, at);
      words.push_back(without_quotes(sql.substr(begin, at - begin)));
      continue;
    }
    while (at < sql.size() && is_word_letter(sql[at])) ++at;
    at = std::max(at, begin + 1);
    words.emplace_back(sql.substr(begin, at - begin));
  }
  return words;
}

bool is(const std::string& word, const char* keyword) {
  return sqlite3_stricmp(word.c_str(), keyword) == 0;
}

bool begins(const Words& words, const std::vector<const char*>& keywords) {
  return words.size() > keywords.size() &&
         std::equal(keywords.begin(), keywords.end(), words.begin(),
                    [](const char* keyword, const std::string& word) { return is(word, keyword); });
}

/// A column of a name and a type of strict tables alone.
bool is_plain_column(const Words& definition) {
  constexpr std::array kTypes = {"REAL", "INTEGER", "INT", "TEXT", "BLOB", "ANY"};
  return definition.size() == 2 &&
         std::ranges::any_of(kTypes, [&](const char* type) { return is(definition[1], type); });
}

/// The words without the plain columns of a CREATE TABLE.
Words without_plain_columns(const Words& words) {
  if (!begins(words, {"CREATE", "TABLE"})) return words;
  Words kept, definition;
  int depth = 0;
  const auto end_definition = [&] {
    if (!is_plain_column(definition)) {
      kept.insert(kept.end(), definition.begin(), definition.end());
      kept.emplace_back(",");
    }
    definition.clear();
  };
  for (const std::string& word : words) {
    if (word == ")" && --depth == 0) end_definition();
    if (depth == 0)
      kept.push_back(word);
    else if (depth == 1 && word == ",")
      end_definition();
    else
      definition.push_back(word);
    if (word == "(") ++depth;
  }
  kept.insert(kept.end(), definition.begin(), definition.end());
  return kept;
}

}  // namespace

bool is_same_definition(std::string_view a, std::string_view b) {
  return without_plain_columns(words_of(a)) == without_plain_columns(words_of(b));
}

bool is_ordinary_table(std::string_view sql) { return begins(words_of(sql), {"CREATE", "TABLE"}); }

bool is_plain_index(std::string_view sql) {
  const Words words = words_of(sql);
  return begins(words, {"CREATE", "INDEX"}) && words.back() == ")" &&
         std::ranges::count(words, "(") == 1;
}

}  // namespace triax::db
