// SPDX-License-Identifier: GPL-3.0-or-later
// print_structure FILE...: what encoding.hpp and structure.hpp find in each file, one TOML table
// per file.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

#include "lab/base/bad_input.hpp"
#include "lab/intake/text/encoding.hpp"
#include "lab/intake/text/structure.hpp"
#include "lab/workbook/sheet_source.hpp"

namespace {
using namespace triax::lab;

std::vector<std::int64_t> row_lines(ByteSource& source, const TableStructure& table) {
  std::vector<std::int64_t> rows;
  source.rewind();
  const auto sample = read_sample(source);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const auto number = sample.number(i);
    if (number < table.first_row_line) continue;
    if (table.last_row_line > 0 && number > table.last_row_line) continue;
    if (std::ranges::count(table.repeated_heading_lines, number) > 0) continue;
    const auto& line = sample.line(i);
    if (!table.comment.empty() && line.starts_with(table.comment)) continue;
    if (line.find_first_not_of(" ,;\t\"|") == std::string::npos) continue;
    rows.push_back(number);
  }
  return rows;
}

void print(ByteSource& source, const std::string& file, const std::string& encoding,
           const std::string& sheet) {
  const auto result = find_structure(read_sample(source));
  fmt::print("[[file]]\nfile = '''{}'''\nencoding = \"{}\"\nsheet = '''{}'''\nreason = '''{}'''\n",
             file, encoding, sheet, result.reason);
  if (!result.structure) return;
  const auto& t = *result.structure;
  fmt::print("separator = \"{}\"\ndecimal = \"{}\"\n", separator_name(t.separator),
             static_cast<char>(t.decimal));
  if (t.thousands != 0) fmt::print("thousands = \"{}\"\n", t.thousands);
  if (!t.comment.empty()) fmt::print("comment = \"{}\"\n", t.comment);
  fmt::print("heading_lines = [{}]\nunit_line = {}\ndata_lines = [{}]\n",
             fmt::join(t.heading_lines, ", "), t.unit_line, fmt::join(row_lines(source, t), ", "));
  if (!t.repeated_heading_lines.empty())
    fmt::print("repeated_heading_lines = [{}]\n", fmt::join(t.repeated_heading_lines, ", "));
  fmt::print("columns = {}\n", t.column_count);
  for (const auto& [key, list] :
       {std::pair("headings", &t.headings), std::pair("units", &t.units)}) {
    fmt::print("{} = [", key);
    for (const auto& one : *list) fmt::print("'''{}''',", one);
    fmt::print("]\n");
  }
  for (const auto& block : t.blocks)
    fmt::print("[[file.blocks]]\nfirst_cell = {}\ncell_count = {}\ntitle = '''{}'''\n",
               block.first_cell, block.cell_count, block.title);
}

void print_file(const std::string& path) {
  auto file = open_file(path);
  if (!looks_like_workbook(*file)) {
    const auto text = open_utf8(std::move(file));
    const auto* const converted = dynamic_cast<const Utf8Source*>(text.get());
    print(*text, path, converted != nullptr ? converted->encoding().name : "UTF-8", "");
    return;
  }
  const std::shared_ptr<ByteSource> behind = std::move(file);
  const auto book = std::make_shared<const Workbook>(ZipArchive::open(path));
  for (const auto& entry : book->sheets()) {
    SheetSource sheet(book, entry, behind);
    print(sheet, path, "UTF-8", entry.name);
  }
}
}  // namespace

int main(int count, char** arguments) {
  for (int i = 1; i < count; ++i) {
    try {
      print_file(arguments[i]);
    } catch (const BadInput& error) {
      fmt::print("[[file]]\nfile = '''{}'''\nreason = '''{}'''\n", arguments[i], error.what());
    }
  }
  return 0;
}
