// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/sentence_table.hpp"

#include <utility>

#include "src/output/terminal.hpp"
#include "src/output/wrapping.hpp"

namespace triax::src {

std::string text_with_sentences(Table table) {
  if (table.rows.empty()) return {};
  constexpr std::size_t kIn = 2, kSentenceIn = 6;
  std::vector<std::string> sentences;
  table.columns.pop_back();
  for (auto& row : table.rows) {
    sentences.push_back(std::move(row.back()));
    row.pop_back();
  }
  const auto widths = column_widths(table, text_width() - kIn);
  std::vector<std::string> headings, rules;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    headings.push_back(table.columns[i].heading);
    rules.emplace_back(widths[i], '-');
  }
  std::string text = indented(table_line(headings, table.columns, widths) + '\n' +
                              table_line(rules, table.columns, widths) + '\n');
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    text += indented(table_line(table.rows[i], table.columns, widths) + '\n');
    if (sentences[i].empty()) continue;
    for (const auto& line : wrapped(on_one_line(sentences[i]), text_width() - kSentenceIn))
      text += std::string(kSentenceIn, ' ') + line + '\n';
  }
  return text;
}

}  // namespace triax::src
