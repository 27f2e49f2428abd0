// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/tables/table_tests.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/text/structure.hpp"
#include "lab/records/rows/sample_rows.hpp"
#include "lab/records/rows/test_restart.hpp"
#include "lab/records/table_reader.hpp"
#include "lab/records/tables/table_recognition.hpp"

namespace triax::lab {
namespace {

/// "cells 1 to 3, 'Specimen 1'"
std::string name_of(const TableBlock& block) {
  return fmt::format("cells {} to {}{}", block.first_cell + 1, block.first_cell + block.cell_count,
                     block.title.empty() ? "" : ", " + excerpt(block.title));
}

/// True if the tables that stand side by side are read one by one. A dialect that is found by its
/// headings reads the whole line.
bool reads_blocks(ByteSource& source, const std::optional<Dialect>& forced) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  try {
    return recognise_table(source, forced, findings, {.block = 1, .first_line = 1}).block_cells > 0;
  } catch (const BadInput&) {
    return true;  // another one may be read
  }
}

/// The tables side by side; one without a number if there is only one.
std::vector<TableTest> find_tables(ByteSource& source, const TableSample& sample,
                                   const std::optional<Dialect>& forced) {
  const StructureResult found = find_structure(sample);
  std::vector<TableTest> tables;
  if (found.structure)
    for (const TableBlock& block : found.structure->blocks)
      tables.push_back({.block = tables.size() + 1, .name = name_of(block)});
  if (tables.empty() || !reads_blocks(source, forced)) return {TableTest()};
  if (tables.size() > kMaxTables)
    throw SeveralTests(source.name(), 0,
                       fmt::format("more than {} tables side by side", kMaxTables));
  return tables;
}

/// The first and last line of the rows of each test that begins in the source.
std::vector<TableTest> find_rows(ByteSource& source, const TableLayout& layout) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  TableReader reader(source, layout, findings);
  TestRestart restart(layout.file);
  std::vector<TableTest> tests;
  Row row;
  std::int64_t last_line = 0;
  while (reader.next(row)) {
    if (tests.empty()) tests.push_back({.first_line = row.line, .name = reader.test_name()});
    last_line = row.line;
    const auto found = restart.find(row);
    if (!found) continue;
    if (tests.size() == kMaxTests)
      throw SeveralTests(layout.file, found->line,
                         fmt::format("more than {} tests in one table", kMaxTests));
    tests.back().last_line = found->line_before;
    tests.push_back(
        {.first_line = found->line, .line_before = found->line_before, .name = reader.test_name()});
  }
  if (!tests.empty()) tests.back().last_line = last_line;
  return tests;
}

std::vector<TableTest> tests_below(ByteSource& source, const TableSample& sample,
                                   const TableLayout& layout, Extent extent) {
  if (layout.is_reversed) return {};
  if (extent == Extent::sample && !sample.whole) {
    const SampleRows ends = sample_rows(sample, layout);
    if (find_rows(*ends.text, ends.layout).size() < 2) return {};
  }
  return find_rows(source, layout);
}

/// The tests of one table, or the table itself if it holds one.
std::vector<TableTest> tests_of(ByteSource& source, const TableSample& sample,
                                const std::optional<Dialect>& forced, const TableTest& table,
                                Extent extent) {
  TableTest all = table;
  all.first_line = 1;
  std::vector<Warning> warnings;
  Findings findings(warnings);
  const TableLayout layout = recognise_table(source, forced, findings, all);
  auto tests = tests_below(source, sample, layout, extent);
  if (tests.size() < 2) return {table};
  for (TableTest& test : tests) {
    test.block = table.block;
    const std::string title = test.name.empty() ? "" : excerpt(test.name);
    test.name =
        joined({table.name, fmt::format("lines {} to {}", test.first_line, test.last_line), title});
  }
  return tests;
}

}  // namespace

std::vector<TableTest> find_tests(ByteSource& source, const std::optional<Dialect>& forced,
                                  Extent extent) {
  TableSample sample;
  try {
    sample = read_sample(source);
  } catch (const BadInput&) {
    return {};  // no text
  }
  return find_tests(source, sample, forced, extent);
}

std::vector<TableTest> find_tests(ByteSource& source, const TableSample& sample,
                                  const std::optional<Dialect>& forced, Extent extent) {
  std::vector<TableTest> tables, tests;
  try {
    tables = find_tables(source, sample, forced);
  } catch (const SeveralTests&) {
    throw;
  } catch (const BadInput&) {
    return {};
  }
  for (const TableTest& table : tables) {
    try {
      std::ranges::move(tests_of(source, sample, forced, table, extent), std::back_inserter(tests));
    } catch (const SeveralTests&) {
      throw;
    } catch (const BadInput&) {
      tests.push_back(table);
    }
  }
  source.rewind();
  return tests.size() < 2 ? std::vector<TableTest>() : tests;
}

}  // namespace triax::lab
