// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Of a span of readings those that a picture of so many pixels needs: real readings, never means.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "src/study/triaxial/test_columns.hpp"

namespace triax::study {

struct WindowAsked {
  std::int64_t from = 0, to = 0;     ///< readings, both inclusive
  std::size_t pixels = 1000;         ///< wide
  std::vector<std::size_t> columns;  ///< places in db::read_columns()
  bool work = false;                 ///< points of second-order work too
};

/// The rows to be drawn, as places in the columns of the test, in order.
struct Window {
  std::int64_t count = 0;  ///< readings of the test within the span
  bool exact = true;       ///< all of them are here
  std::vector<std::size_t> rows;
  bool work_exact = true;
  std::vector<std::size_t> work;  ///< places in its points of second-order work
};

/// In each of `pixels` equal runs of readings the first of those with the least and with the
/// largest value of each column that is drawn (time and stage are not), the first and last reading
/// of the span, and those where a line breaks (unread steps, faults); all where they are no more
/// than that. Pre-condition: the columns were read.
Window window(const TestColumns& test, const WindowAsked& asked);

/// Of values at `places` in order: the first place of the least and of the largest finite value of
/// each of `buckets` equal runs.
void keep_extremes(std::span<const double> values, std::size_t begin, std::size_t end,
                   std::size_t buckets, std::vector<std::size_t>& kept);

/// Returns the window as JSON for the web interface (docs/how-to/browser.md): columns by name,
/// missing values null, with the unread steps and faults of the test. Numbers have the fewest
/// digits that give them back exactly.
std::string window_json(const TestColumns& test, const WindowAsked& asked);

}  // namespace triax::study
