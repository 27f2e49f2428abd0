#include "src/output/table.hpp"

#include <clocale>
#include <cwchar>

#include <algorithm>
#include <memory>
#include <utility>

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

std::string blanked(std::string text, bool keep_line_breaks) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == '\n' && keep_line_breaks) continue;
    if (c < ' ' || c == 0x7f) text[i] = ' ';
    // U+0080 to U+009F, among them a CSI that some terminals obey.
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
    if (c == 0xc2 && next >= 0x80 && next < 0xa0) text.replace(i, 2, " ");
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
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string cell = on_one_line(cells[i]);
    const std::size_t width = display_width(cell);
    const std::string padding(width < widths[i] ? widths[i] - width : 0, ' ');
    if (i > 0) line += "  ";
    line += columns[i].align == Align::right ? padding + cell : cell + padding;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::vector<std::size_t> column_widths(const Table& table) {
  std::vector<std::size_t> widths;
  for (const auto& column : table.columns)
    widths.push_back(display_width(on_one_line(column.heading)));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], display_width(on_one_line(row[i])));
  return widths;
}

std::string to_text(const Table& table) {
  const auto widths = column_widths(table);
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
