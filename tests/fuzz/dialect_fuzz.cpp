// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as the description of a dialect, then a small record through it.
#include <cstddef>
#include <cstdint>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/records/dialect.hpp"
#include "lab/records/table_reader.hpp"
#include "lab/records/tables/table_recognition.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  std::string toml(size, '\0');
  for (std::size_t i = 0; i < size; ++i) toml[i] = static_cast<char>(data[i]);
  try {
    const Dialect dialect = parse_dialect(toml, "fuzz.toml");
    const auto source = open_memory(
        "record", "eps1 (%);q (kPa);p (kPa);t (s);stage\n0;1;100;0;1\n0,1;2,5;99;1;1\n1;2;3;2;2\n");
    std::vector<Warning> warnings;
    Findings findings(warnings);
    const TableLayout layout = recognise_table(*source, dialect, findings);
    TableReader reader(*source, layout, findings);
    Row row;
    while (reader.next(row)) {
    }
  } catch (const BadInput&) {
    return 0;
  }
  return 0;
}
