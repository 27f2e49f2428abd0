// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

/// Longest line that is taken for a line of a record, bytes.
inline constexpr std::size_t kMaxLine_bytes = std::size_t{1} << 20;

/// Lines of a text file in constant memory: no more than one block and one line are held.
/// A byte-order mark is dropped, LF and CR LF both end a line.
class LineReader {
 public:
  /// Reads `source` from its first byte.
  explicit LineReader(ByteSource& source);

  /// The next line without its end, valid until the next call; false at the end of the file.
  /// Throws BadInput on a line above kMaxLine_bytes and on NUL bytes: that is no text.
  bool next(std::string_view& line);
  /// Number of the line that next() gave last, from 1.
  std::int64_t line_number() const { return line_number_; }
  /// True if the line that next() gave last ended with the file, not with a line end.
  bool cut_off() const { return cut_off_; }
  /// Bytes taken so far.
  std::uint64_t position() const { return taken_; }

 private:
  bool fill();

  ByteSource& source_;
  std::size_t block_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint64_t taken_ = 0;
  std::int64_t line_number_ = 0;
  bool cut_off_ = false;
};

}  // namespace triax::lab
