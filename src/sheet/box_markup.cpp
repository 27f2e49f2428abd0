// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "src/output/markup.hpp"
#include "src/sheet/sheet.hpp"

namespace triax::src {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "q 45.0 kPa" stays on one line: no break between a number and a short word beside it.
std::string kept_together(std::string text) {
  constexpr std::size_t kShort = 5;  // bytes: p′, ε₁, kPa
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    if (at == 0 || at + 1 == text.size()) continue;
    const auto begin = text.find_last_of(" \u00A0", at - 1);
    const std::size_t before = begin == std::string::npos ? at : at - begin - 1;
    const auto end = std::min(text.find_first_of(" ,;.", at + 1), text.size());
    const bool unit = is_digit(text[at - 1]) && !is_digit(text[at + 1]) && end - at - 1 <= kShort;
    const bool symbol = is_digit(text[at + 1]) && !is_digit(text[at - 1]) && before <= kShort;
    if (unit || symbol) text.replace(at, 1, "\u00A0");
  }
  return text;
}

std::string value_cell(const Fact& fact) {
  std::string lines;
  for (const auto& line : fact.lines)
    lines += (lines.empty() ? "" : "<br/>") + escaped(kept_together(line));
  return fmt::format("<td class=\"{}\">{}</td>", lines.empty() ? "blank" : "value",
                     lines.empty() ? "&nbsp;" : lines);
}

std::string facts_in_columns(const SheetBox& box) {
  std::string html = "<table class=\"facts\" width=\"100%\" cellspacing=\"0\" cellpadding=\"1\">\n";
  const auto columns = static_cast<std::size_t>(box.columns);
  for (std::size_t i = 0; i < box.facts.size(); i += columns) {
    html += "<tr>";
    for (std::size_t k = i; k < i + columns; ++k)
      html += k < box.facts.size()
                  ? fmt::format("<td class=\"label\">{}&nbsp;&nbsp;</td>{}",
                                escaped(box.facts[k].label), value_cell(box.facts[k]))
                  : "<td></td><td></td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string table_of(const Table& table) {
  std::string html =
      "<table class=\"rows\" width=\"98%\" cellspacing=\"0\" cellpadding=\"1\">\n<tr>";
  const auto cell = [&](const char* tag, std::size_t i, const std::string& text) {
    return fmt::format("<{0} align=\"{1}\">{2}</{0}>", tag,
                       table.columns[i].align == Align::right ? "right" : "left",
                       text.empty() ? "&nbsp;" : escaped(text));
  };
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    html += cell("th", i, table.columns[i].heading);
  html += "</tr>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) html += cell("td", i, row[i]);
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace

std::string box_markup(const SheetBox& box) {
  std::string html;
  if (!box.title.empty())
    html += fmt::format("<div class=\"title\">{}</div>\n", escaped(box.title));
  if (!box.facts.empty()) html += facts_in_columns(box);
  if (!box.table.columns.empty()) html += table_of(box.table);
  for (const auto& line : box.lines)
    html += fmt::format("<div class=\"line\">{}</div>\n", escaped(line));
  if (box.blank_lines > 0) {
    html += "<table class=\"facts\" width=\"100%\" cellspacing=\"0\" cellpadding=\"1\">\n";
    for (int i = 0; i < box.blank_lines; ++i) html += "<tr><td class=\"blank\">&nbsp;</td></tr>\n";
    html += "</table>\n";
  }
  return html;
}

}  // namespace triax::src
