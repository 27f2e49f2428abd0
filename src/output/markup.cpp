// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/markup.hpp"

#include <fmt/format.h>

#include <QString>

namespace triax::src {
namespace {

/// Beside what no XML may hold: U+007F to U+009F, and what turns the order of reading round or
/// breaks lines.
bool allowed_in_xml(QChar character) {
  const auto code = character.unicode();
  const auto between = [code](char16_t first, char16_t last) {
    return code >= first && code <= last;
  };
  if (between(0x7F, 0x9F) || code == 0x061C || between(0x200E, 0x200F) || between(0x2028, 0x202E) ||
      between(0x2066, 0x2069))
    return false;
  return code == '\t' || code == '\n' || code == '\r' ||
         (code >= 0x20 && code != 0xFFFE && code != 0xFFFF);
}

std::string align_attribute(const Column& column) {
  return column.align == Align::right ? " align=\"right\"" : "";
}

}  // namespace

std::string in_xml(const std::string& markup) {
  auto unicode = QString::fromStdString(markup);
  for (auto& character : unicode)
    if (!allowed_in_xml(character)) character = QChar::ReplacementCharacter;
  return unicode.toStdString();
}

std::string escaped(const std::string& text) {
  return QString::fromStdString(in_xml(text)).toHtmlEscaped().replace('\'', "&#39;").toStdString();
}

std::string table_markup(const Table& table, const std::vector<std::string>& anchors,
                         std::size_t anchor_column) {
  std::string html = "<table class=\"data\" cellspacing=\"0\" cellpadding=\"3\">\n<thead><tr>";
  for (const auto& column : table.columns)
    html += fmt::format("<th{}>{}</th>",
                        column.align == Align::right ? align_attribute(column) : " align=\"left\"",
                        escaped(column.heading));
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    html += "<tr>";
    for (std::size_t i = 0; i < table.rows[row].size(); ++i) {
      auto cell = escaped(table.rows[row][i]);
      if (i == anchor_column && row < anchors.size())
        cell = fmt::format("<a href=\"#{}\">{}</a>", escaped(anchors[row]), cell);
      html += fmt::format("<td{}>{}</td>", align_attribute(table.columns[i]), cell);
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

std::string facts_markup(const std::vector<Fact>& facts) {
  std::string html = "<table class=\"facts\" cellspacing=\"0\" cellpadding=\"3\">\n";
  for (const auto& fact : facts) {
    std::string lines;
    for (const auto& line : fact.lines) lines += (lines.empty() ? "" : "<br/>") + escaped(line);
    html +=
        fmt::format("<tr><th align=\"left\">{}</th><td>{}</td></tr>\n", escaped(fact.label), lines);
  }
  return html + "</table>\n";
}

}  // namespace triax::src
