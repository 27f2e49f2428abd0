// SPDX-License-Identifier: GPL-3.0-or-later
// Any lines as the cells of a column of clocks: a format that is found reads most of them, and the
// time of the test is finite.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/text.hpp"
#include "lab/intake/cells/clock_format.hpp"
#include "lab/intake/cells/fill_values.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace triax::lab;
  std::string text(size, '\0');
  for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(data[i]);
  std::vector<std::string_view> cells;
  for (std::string_view rest = text; !rest.empty();) {
    const auto end = rest.find('\n');
    cells.push_back(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  for (const auto heading : {ClockHeading::time, ClockHeading::date, ClockHeading::time_of_day}) {
    const ClockFinding found = find_clock_format(cells, heading);
    if (!found.format) continue;
    if (found.evidence.empty() || describe(*found.format).empty()) std::abort();
    Clock clock(*found.format);
    std::size_t fits = 0, misfits = 0;
    for (const auto cell : cells) {
      const auto seconds = clock_seconds(*found.format, cell);
      if (!seconds) misfits += is_fill_text(trimmed(cell)) ? 0 : 1;
      if (!seconds) continue;
      if (!std::isfinite(*seconds)) std::abort();
      const auto time = read_clock(*found.format, trimmed(cell));
      if (!time || !std::isfinite(clock.since_start(*time))) std::abort();
      ++fits;
    }
    if (fits == 0 || fits < misfits) std::abort();
  }
  return 0;
}
