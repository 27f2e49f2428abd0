// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table of text with units in its headings: what text, HTML and PDF reports have in common.
#include <cstdint>
#include <string>
#include <vector>

namespace triax::src {

enum class Align { left, right };

struct Column {
  std::string heading;  ///< with its unit: "p'0 (kPa)"
  Align align = Align::left;
};

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
};

/// Columns a terminal needs for UTF-8 text (combining marks none, wide characters two).
std::size_t display_width(const std::string& utf8);

/// Blanks in place of control characters (a line break would break a table, ESC command a
/// terminal), also of those above ASCII and of marks that turn the order of reading round; U+FFFD
/// in place of bytes that are no UTF-8.
std::string on_one_line(std::string utf8);
/// The same for a text of several lines, whose line breaks stay.
std::string without_controls(std::string utf8);

/// One row of a table: cells on_one_line(), padded to `widths`, two blanks between, no blanks at
/// the end. What is wider than its column goes on in further lines, broken at blanks; a word never
/// is.
std::string table_line(const std::vector<std::string>& cells, const std::vector<Column>& columns,
                       const std::vector<std::size_t>& widths);

/// The width each column gets. Where all on one line would be wider than `line`, headings and the
/// cells of columns to the left give way, the widest first, down to their longest words; numbers
/// never do, so that a table of many of them may stay wider.
std::vector<std::size_t> column_widths(const Table& table, std::size_t line);

/// Headings, a rule and the rows, each line ended, for a terminal of this width.
std::string to_text(const Table& table, std::size_t line);
/// The same for text_width() less the two blanks by which most tables are indented().
std::string to_text(const Table& table);

/// Each line two blanks further in; the last one is ended.
std::string indented(const std::string& lines);

}  // namespace triax::src
