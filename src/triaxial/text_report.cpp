// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/text_report.hpp"

#include <algorithm>
#include <sstream>

#include "src/output/sentence_table.hpp"
#include "src/output/terminal.hpp"

namespace triax::src {
namespace {

// Words of `text` on lines of at most text_width(), continued at `indent`; words are never cut.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string out, word;
  std::size_t column = indent;
  while (words >> word) {
    const auto width = display_width(word);
    if (column > indent && column + 1 + width > text_width()) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      out += ' ';
      ++column;
    }
    out += word;
    column += width;
  }
  return out;
}

std::string below(const Table& table) {
  return table.rows.empty() ? std::string() : '\n' + text_with_sentences(table);
}

}  // namespace

std::string facts_text(const std::vector<Fact>& facts) {
  std::size_t label_width = 0;
  for (const auto& fact : facts) label_width = std::max(label_width, display_width(fact.label));
  const std::size_t indent = label_width + 4;
  std::string text;
  for (const auto& fact : facts) {
    auto label = fact.label;
    for (const auto& line : fact.lines) {
      text += "  " + label + std::string(indent - 2 - display_width(label), ' ');
      text += wrapped(line, indent) + '\n';
      label.clear();
    }
  }
  return text;
}

std::string text_of(const TestContent& content) {
  std::string text = content.title + '\n';
  text += std::string(display_width(content.title), '=') + '\n';
  if (!content.banner.empty()) text += "*** " + wrapped(content.banner, 4) + " ***\n";
  text += facts_text(content.facts);
  text += below(content.criteria);
  text += below(content.events);
  text += below(content.checks);
  return text;
}

std::string text_of_test(const study::TestResult& test) { return text_of(test_content(test)); }

std::string text_report(const std::vector<study::TestResult>& tests) {
  if (tests.empty()) return "The database holds no test.\n";
  std::string text = to_text(summary_table(tests)) + '\n';
  for (const auto& note : summary_notes()) text += wrapped(note, 0) + '\n';
  for (const auto& test : tests) text += '\n' + text_of_test(test);
  return text;
}

}  // namespace triax::src
