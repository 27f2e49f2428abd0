// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/sample_rows.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace triax::lab {

SampleRows sample_rows(const TableSample& sample, const TableLayout& layout) {
  const auto first_count = static_cast<std::int64_t>(sample.first.size());
  const auto line_in_text = [&](std::int64_t line) {
    if (line <= first_count) return line;
    return std::max(first_count, line - sample.last_line_number + first_count + 1);
  };
  std::string text;
  for (std::size_t i = 0; i < sample.size(); ++i) text += sample.line(i) + '\n';
  SampleRows out{open_memory(layout.file, std::move(text)), layout};
  out.layout.last_row_line = line_in_text(layout.last_row_line);
  std::vector<std::int64_t> others;
  for (const std::int64_t line : layout.other_lines)
    if (line <= first_count || line >= sample.last_line_number)
      others.push_back(line_in_text(line));
  out.layout.other_lines = std::move(others);
  return out;
}

}  // namespace triax::lab
