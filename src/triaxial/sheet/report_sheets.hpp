// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// What a report of pages consists of.
struct ReportSheets {
  std::vector<SheetTest> tests;
  /// A page of each test, however many there are; else of no more than kMostSheets.
  bool each = false;
  /// Behind each page the tables and histories that the verdict rests on.
  bool evidence = false;

  /// Of more tests only the sets have pages.
  static constexpr std::size_t kMostSheets = 24;
  bool has_page_of_each() const { return each || tests.size() <= kMostSheets; }
};

}  // namespace triax::src
