// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a text with a table: its encoding and its structure are found, or BadInput is
// thrown.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/intake/text/encoding.hpp"
#include "lab/intake/text/file_kind.hpp"
#include "lab/intake/text/structure.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  std::string bytes(size, '\0');
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(data[i]);
  find_file_kind(bytes);
  try {
    const auto source = open_utf8(open_memory("fuzz", std::move(bytes)));
    const auto result = find_structure(read_sample(*source));
    if (!result.structure && result.reason.empty()) std::abort();
    if (!result.structure) return 0;
    const TableStructure& table = *result.structure;
    if (table.column_count < 2 || table.headings.size() != table.column_count) std::abort();
    if (table.last_row_line > 0 && table.last_row_line < table.first_row_line) std::abort();
    for (const TableBlock& block : table.blocks)
      if (block.first_cell + block.cell_count > table.column_count) std::abort();
  } catch (const BadInput&) {
    return 0;
  }
  return 0;
}
