// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_table.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/line_reader.hpp"
#include "lab/base/text.hpp"
#include "lab/records/cells/cells.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMostTableRows = 20000;

}  // namespace

PathTable read_path_table(const std::string& path) {
  const auto source = open_file(path);
  LineReader lines(*source);
  PathTable table;
  std::vector<std::string_view> cells;
  DecimalMark mark = DecimalMark::point;
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    split_cells(line, Separator::comma, cells);
    if (table.headings.empty()) {
      table.headings.assign(cells.begin(), cells.end());
      continue;
    }
    const auto fail = [&](const std::string& message) {
      throw BadInput(path, lines.line_number(), message);
    };
    if (cells.size() != table.headings.size())
      fail(fmt::format("{} cells for {} headings", cells.size(), table.headings.size()));
    if (table.rows.size() == kMostTableRows) fail(fmt::format("more than {} rows", kMostTableRows));
    auto& row = table.rows.emplace_back(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (parse_cell(trimmed(cells[i]), mark, row[i]) != CellKind::number)
        fail(fmt::format("column {}: {} is not a number", excerpt(table.headings[i]),
                         excerpt(cells[i])));
    table.lines.push_back(lines.line_number());
  }
  if (table.rows.empty()) throw BadInput(path, 0, "no row of numbers below the headings");
  return table;
}

}  // namespace triax::lab
