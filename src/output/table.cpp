// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/table.hpp"

#include <clocale>
#include <cwchar>

#include <algorithm>
#include <memory>
#include <numeric>
#include <string_view>
#include <utility>

#include "src/output/terminal.hpp"
#include "src/output/wrapping.hpp"

namespace triax::src {
namespace {

// wcwidth knows Unicode only under a UTF-8 locale; this one is built into the C library and leaves
// the program's own locale (decimal points!) alone.
class Utf8Locale {
 public:
  Utf8Locale() : locale_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {}
  ~Utf8Locale() {
    if (locale_) freelocale(locale_);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;
  locale_t get() const { return locale_; }

 private:
  locale_t locale_;
};

/// U+FFFD.
constexpr std::string_view kReplacement = "\xef\xbf\xbd";

/// Whether a character at `text[i]` turns the order of reading round or breaks lines: U+061C,
/// U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069.
bool direction_mark(const std::string& text, std::size_t i) {
  const auto at = [&](std::size_t k) {
    return static_cast<unsigned char>(i + k < text.size() ? text[i + k] : 0);
  };
  if (at(0) == 0xd8 && at(1) == 0x9c) return true;
  if (at(0) != 0xe2) return false;
  const unsigned char last = at(2);
  return (at(1) == 0x80 && (last == 0x8e || last == 0x8f || (last >= 0xa8 && last <= 0xae))) ||
         (at(1) == 0x81 && last >= 0xa6 && last <= 0xa9);
}

/// Bytes of the UTF-8 character that begins at `text[i]`; 0 where none does.
std::size_t bytes_of_character(const std::string& text, std::size_t i) {
  const auto at = [&](std::size_t k) {
    return static_cast<unsigned char>(i + k < text.size() ? text[i + k] : 0);
  };
  const unsigned char first = at(0);
  const std::size_t bytes = first < 0x80                    ? 1
                            : first >= 0xc2 && first < 0xe0 ? 2
                            : first >= 0xe0 && first < 0xf0 ? 3
                            : first >= 0xf0 && first < 0xf5 ? 4
                                                            : 0;
  for (std::size_t k = 1; k < bytes; ++k)
    if ((at(k) & 0xc0U) != 0x80) return 0;
  return bytes;
}

std::string blanked(std::string text, bool keep_line_breaks) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t bytes = bytes_of_character(text, i);
    if (bytes == 0) {
      text.replace(i, 1, kReplacement);  // a byte alone may be a CSI, too
      i += kReplacement.size() - 1;
      continue;
    }
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == '\n' && keep_line_breaks) continue;
    if (c < ' ' || c == 0x7f) text[i] = ' ';
    // U+0080 to U+009F, among them a CSI that some terminals obey.
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
    if ((c == 0xc2 && next < 0xa0) || direction_mark(text, i))
      text.replace(i, bytes, " ");
    else
      i += bytes - 1;
  }
  return text;
}

}  // namespace

std::string on_one_line(std::string utf8) { return blanked(std::move(utf8), false); }

std::string without_controls(std::string utf8) { return blanked(std::move(utf8), true); }

std::size_t display_width(const std::string& utf8) {
  static const Utf8Locale kUtf8;
  const locale_t before = kUtf8.get() ? uselocale(kUtf8.get()) : nullptr;
  std::size_t width = 0;
  std::mbstate_t state{};
  const char* at = utf8.data();
  const char* const end = at + utf8.size();
  while (at < end) {
    wchar_t character = 0;
    const std::size_t used =
        std::mbrtowc(&character, at, static_cast<std::size_t>(end - at), &state);
    if (used == 0 || used > static_cast<std::size_t>(end - at)) {  // a byte that is no UTF-8
      state = {};
      ++at;
      ++width;
      continue;
    }
    width += static_cast<std::size_t>(std::max(0, wcwidth(character)));
    at += used;
  }
  if (before) uselocale(before);
  return width;
}

std::string table_line(const std::vector<std::string>& cells, const std::vector<Column>& columns,
                       const std::vector<std::size_t>& widths) {
  std::vector<std::vector<std::string>> parts;
  std::size_t height = 1;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    parts.push_back(wrapped(on_one_line(cells[i]), widths[i]));
    height = std::max(height, parts.back().size());
  }
  std::string text;
  for (std::size_t k = 0; k < height; ++k) {
    std::string line;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string part = k < parts[i].size() ? parts[i][k] : "";
      const std::size_t width = display_width(part);
      const std::string padding(width < widths[i] ? widths[i] - width : 0, ' ');
      if (i > 0) line += "  ";
      line += columns[i].align == Align::right ? padding + part : part + padding;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += (k > 0 ? "\n" : "") + line;
  }
  return text;
}

std::vector<std::size_t> column_widths(const Table& table, std::size_t line) {
  const std::size_t columns = table.columns.size();
  std::vector<std::size_t> widths(columns), least(columns);
  const auto use = [&](std::size_t i, const std::string& cell, bool may_wrap) {
    const std::string text = on_one_line(cell);
    const std::size_t width = display_width(text);
    widths[i] = std::max(widths[i], width);
    least[i] = std::max(least[i], may_wrap ? longest_word(text) : width);
  };
  for (std::size_t i = 0; i < columns; ++i) use(i, table.columns[i].heading, true);
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      use(i, row[i], table.columns[i].align == Align::left);
  const auto total = [&] {
    return std::accumulate(widths.begin(), widths.end(),
                           2 * (columns - std::min<std::size_t>(1, columns)));
  };
  while (total() > line) {
    std::size_t widest = columns;
    for (std::size_t i = 0; i < columns; ++i)
      if (widths[i] > least[i] && (widest == columns || widths[i] > widths[widest])) widest = i;
    if (widest == columns) break;
    --widths[widest];
  }
  return widths;
}

std::string to_text(const Table& table, std::size_t line) {
  const auto widths = column_widths(table, line);
  std::vector<std::string> headings, rules;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    headings.push_back(table.columns[i].heading);
    rules.emplace_back(widths[i], '-');
  }
  std::string text = table_line(headings, table.columns, widths) + '\n' +
                     table_line(rules, table.columns, widths) + '\n';
  for (const auto& row : table.rows) text += table_line(row, table.columns, widths) + '\n';
  return text;
}

std::string to_text(const Table& table) {
  constexpr std::size_t kIndentation = 2;
  return to_text(table, text_width() - kIndentation);
}

std::string indented(const std::string& lines) {
  std::string out = "  ";
  for (const char c : lines) {
    out += c;
    if (c == '\n') out += "  ";
  }
  out.erase(out.size() - 2);
  return out;
}

}  // namespace triax::src
