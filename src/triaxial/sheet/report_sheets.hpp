// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// What a report of pages consists of.
struct ReportSheets {
  std::vector<SheetTest> tests;
  /// Loads a test of which `tests` holds few states only (keep_few_states), for its own page; empty
  /// where they hold all.
  std::function<SheetTest(const SheetTest&)> whole{};
  /// A page of each test, however many there are; else of no more than kMostSheets.
  bool each = false;
  /// Behind each page the tables and histories that the verdict rests on.
  bool evidence = false;

  /// Of more tests only the sets have pages.
  static constexpr std::size_t kMostSheets = 24;
  bool has_page_of_each() const { return each || tests.size() <= kMostSheets; }
  /// Calls `draw` with each test in turn, whole; no two are held at a time.
  template <class Draw>
  void for_each_page(const Draw& draw) const {
    if (!has_page_of_each()) return;
    for (const auto& test : tests) whole ? draw(whole(test)) : draw(test);
  }
};

}  // namespace triax::src
