// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/table_sample.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <string_view>

#include "lab/base/line_reader.hpp"

namespace triax::lab {

TableSample read_sample(ByteSource& source) {
  TableSample sample;
  if (const auto* const with_more = dynamic_cast<const HasLinesBeside*>(&source))
    sample.beside = with_more->lines_beside();
  LineReader reader(source);
  std::string_view line;
  std::size_t bytes = 0;
  bool is_open = true;
  std::deque<std::string> last;
  std::size_t last_bytes = 0;
  while (reader.next(line)) {
    is_open = is_open && sample.first.size() < kSampleLines &&
              (sample.first.empty() || bytes + line.size() <= kMaxSampleBytes);
    if (is_open) {
      bytes += line.size();
      sample.first.emplace_back(line);
      continue;
    }
    last_bytes += line.size();
    std::string kept;
    if (last.size() == kSampleLines) {  // with its memory
      kept = std::move(last.front());
      last_bytes -= kept.size();
      last.pop_front();
      sample.whole = false;
    }
    kept.assign(line);
    last.push_back(std::move(kept));
    while (last.size() > 1 && (last.size() > kSampleLines || last_bytes > kMaxSampleBytes)) {
      last_bytes -= last.front().size();
      last.pop_front();
      sample.whole = false;
    }
  }
  if (!last.empty())
    sample.last_line_number = reader.line_number() - static_cast<std::int64_t>(last.size()) + 1;
  std::ranges::move(last, std::back_inserter(sample.last));
  return sample;
}

}  // namespace triax::lab
