// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/chosen_test.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/diggs/diggs_source.hpp"
#include "lab/intake/text/table_sample.hpp"
#include "lab/rig/sheet_record.hpp"
#include "lab/workbook/sheet_source.hpp"

namespace triax::lab {
namespace {

/// dialect_for() without its finding.
std::optional<Dialect> quiet_dialect(ByteSource& source, const RecordOptions& options) {
  std::vector<Warning> warnings;
  Findings findings(warnings);
  return dialect_for(source, options, findings);
}

using OpenTable = std::function<std::unique_ptr<ByteSource>(const RecordOptions&)>;

/// The tests of a workbook with several worksheets of readings.
std::vector<TableTest> tests_of_sheets(const std::shared_ptr<const SheetRoles>& sheets,
                                       const RecordOptions& options, Extent extent,
                                       const OpenTable& open_table) {
  std::vector<TableTest> all;
  RecordOptions one = options;
  one.tests = std::make_shared<const TestsInFile>(TestsInFile{.sheets = sheets});
  for (const std::string& name : sheets->tests) {
    one.sheet = name;
    const auto table = open_table(one);
    auto tests = find_tests(*table, quiet_dialect(*table, one), extent);
    if (tests.empty()) tests.emplace_back();
    for (TableTest& test : tests) {
      test.sheet = name;
      test.name = joined({"worksheet " + excerpt(name), test.name});
    }
    std::ranges::move(tests, std::back_inserter(all));
  }
  return all;
}

/// `open_table` opens the same file as a table.
TestsInFile tests_of(std::unique_ptr<ByteSource> file, const RecordOptions& options, Extent extent,
                     const OpenTable& open_table) {
  TestsInFile tests;
  if (looks_like_diggs(*file)) {
    tests.document = std::make_shared<const DiggsDocument>(read_diggs(*file));
    tests.names = diggs_tests(*tests.document);
    return tests;
  }
  file.reset();
  std::unique_ptr<ByteSource> table;
  try {
    table = open_table(options);
    const auto* const sheet = dynamic_cast<const SheetSource*>(table.get());
    if (sheet) tests.sheets = sheet->roles();
    const auto dialect = named_dialect(options);
    const bool is_named = !options.sheet.empty() || (dialect && !dialect->sheet.empty());
    if (sheet && !is_named && tests.sheets->tests.size() > 1) {
      tests.tables = tests_of_sheets(tests.sheets, options, extent, open_table);
      for (const TableTest& test : tests.tables) tests.names.push_back(test.name);
      return tests;
    }
    tests.sample = std::make_shared<const TableSample>(read_sample(*table));
  } catch (const BadInput&) {
    return tests;  // reported by open_record()
  }
  tests.tables = find_tests(*table, *tests.sample, quiet_dialect(*table, options), extent);
  for (const TableTest& test : tests.tables) tests.names.push_back(test.name);
  return tests;
}

}  // namespace

TableTest chosen_test(ByteSource& source, const RecordOptions& options) {
  const bool is_diggs = dynamic_cast<const DiggsSource*>(&source) != nullptr;
  if (options.test == 0 || is_diggs) return {};
  const auto tables =
      options.tests ? options.tests->tables : find_tests(source, quiet_dialect(source, options));
  if (tables.empty() && options.test == 1) return {};
  if (options.test > tables.size())
    throw BadInput(source.name(), 0,
                   fmt::format("there is no test {}; the file has {}", options.test,
                               std::max<std::size_t>(tables.size(), 1)));
  return tables[options.test - 1];
}

TestsInFile tests_in(const std::string& path, const RecordOptions& options, Extent extent) {
  const RecordOptions complete = with_dialect_beside(path, options);
  return tests_of(open_file(path), complete, extent,
                  [&](const RecordOptions& of_sheet) { return open_readings(path, of_sheet); });
}

TestsInFile tests_in(const std::function<std::unique_ptr<ByteSource>()>& open,
                     const RecordOptions& options, Extent extent) {
  return tests_of(open(), options, extent,
                  [&](const RecordOptions& of_sheet) { return sheet_or_text(open(), of_sheet); });
}

}  // namespace triax::lab
