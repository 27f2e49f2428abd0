// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The begin and the end of a text file, from which the structure of its table is found.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

/// A source whose file has more lines that can state values of its table.
class HasLinesBeside {
 public:
  virtual ~HasLinesBeside() = default;
  /// Lines of CSV: those of other worksheets.
  virtual const std::vector<std::string>& lines_beside() const = 0;
};

struct TableSample {
  std::vector<std::string> first;     ///< lines from the first one on, UTF-8
  std::vector<std::string> last;      ///< the last lines that are not in `first`
  std::int64_t last_line_number = 0;  ///< line number of last.front(), 0 if `last` is empty
  bool whole = true;                  ///< no line is missing between `first` and `last`
  std::vector<std::string> beside;    ///< HasLinesBeside::lines_beside() of the source

  std::size_t size() const { return first.size() + last.size(); }
  /// Line `i` of those that are held.
  const std::string& line(std::size_t i) const {
    return i < first.size() ? first[i] : last[i - first.size()];
  }
  /// Number of that line in the file, from 1.
  std::int64_t number(std::size_t i) const {
    return i < first.size() ? static_cast<std::int64_t>(i) + 1
                            : last_line_number + static_cast<std::int64_t>(i - first.size());
  }
};

inline constexpr std::size_t kSampleLines = 1000;
/// Bytes of each part of a sample, which then has fewer lines. One line is always held.
inline constexpr std::size_t kMaxSampleBytes = std::size_t{1} << 20;

/// Reads `source`, which gives UTF-8, from its first byte to its last, in constant memory. Throws
/// BadInput for what is no text (LineReader).
TableSample read_sample(ByteSource& source);

}  // namespace triax::lab
