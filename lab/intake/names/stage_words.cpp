// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/names/stage_words.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "lab/base/names.hpp"
#include "lab/intake/names/heading_form.hpp"
#include "lab/intake/names/lexicon_file.hpp"
#include "lab/intake/names/phrase_table.hpp"

namespace triax::lab {
namespace {

constexpr std::array<std::pair<LoadDirection, std::string_view>, 2> kDirections{
    {{LoadDirection::compression, "compression"}, {LoadDirection::extension, "extension"}}};
LoadDirection direction_of(const TomlTable& row) {
  return value_of<LoadDirection>(row.text("direction").value_or(""), kDirections)
      .value_or(LoadDirection::unknown);
}

Drainage drainage_of(const TomlTable& row) {
  return drainage_from(row.text("drainage").value_or("unknown")).value_or(Drainage::unknown);
}

void add_phrases(PhraseTable& table, const std::vector<std::string>& phrases, std::size_t number) {
  for (const std::string& phrase : phrases)
    table.add(heading_tokens(repair_heading(phrase)), static_cast<int>(number));
}

struct StageWordTables {
  PhraseTable stages, drainages, directions;
  std::vector<StageWords> stage_rows;
  std::vector<Drainage> drainage_rows;
  std::vector<LoadDirection> direction_rows;
};

StageWordTables read_tables() {
  const TomlTable file = read_lexicon_file("stages");
  StageWordTables tables;
  for (const TomlTable& row : file.tables("stage")) {
    const TomlTable words = row.required_table("words");
    for (const std::string& language : words.keys())
      add_phrases(tables.stages, words.texts(language), tables.stage_rows.size());
    tables.stage_rows.push_back(
        {.role = stage_role_from(row.required_text("role")).value_or(StageRole::unknown),
         .is_cyclic = row.flag("cyclic").value_or(false)});
  }
  for (const TomlTable& row : file.tables("drainage")) {
    add_phrases(tables.drainages, row.texts("words"), tables.drainage_rows.size());
    tables.drainage_rows.push_back(drainage_of(row));
  }
  for (const TomlTable& row : file.tables("direction")) {
    add_phrases(tables.directions, row.texts("words"), tables.direction_rows.size());
    tables.direction_rows.push_back(direction_of(row));
  }
  return tables;
}

const StageWordTables& stage_words() {
  static const StageWordTables tables = read_tables();
  return tables;
}

/// The row of the longest phrase that the text contains.
template <class Row>
std::optional<Row> longest_phrase(const PhraseTable& table, const std::vector<Row>& rows,
                                  const std::vector<QString>& tokens) {
  const auto matches = table.find(tokens);
  if (matches.empty()) return std::nullopt;
  return rows[static_cast<std::size_t>(matches.front().number)];
}

StageWords read_words(const std::vector<QString>& tokens) {
  const StageWordTables& tables = stage_words();
  StageWords words =
      longest_phrase(tables.stages, tables.stage_rows, tokens).value_or(StageWords{});
  words.drainage =
      longest_phrase(tables.drainages, tables.drainage_rows, tokens).value_or(Drainage::unknown);
  words.direction = longest_phrase(tables.directions, tables.direction_rows, tokens)
                        .value_or(LoadDirection::unknown);
  for (const auto& match : tables.stages.find(tokens))
    words.is_cyclic =
        words.is_cyclic || tables.stage_rows[static_cast<std::size_t>(match.number)].is_cyclic;
  return words;
}

/// Without text that is too long to be a name.
QString repair_name(std::string_view text) {
  constexpr std::size_t kMaxNameBytes = 800;
  return text.size() > kMaxNameBytes ? QString() : repair_heading(text);
}

}  // namespace

StageWords read_stage_words(std::string_view text) {
  QString name = repair_name(text);
  const StageWords words = read_words(heading_tokens(name));
  if (words.role != StageRole::unknown) return words;
  for (QChar& c : name)
    if (c.isDigit()) c = u' ';
  return read_words(heading_tokens(name));
}

}  // namespace triax::lab
