// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

/// A text with lines `first_line` to `last_line` in reverse order, each with a line end. Reads a
/// source that is seekable in blocks from its end, in constant memory; the lines of another source
/// are held in memory.
class ReversedRows final : public ByteSource {
 public:
  /// Throws BadInput if lines that are to be held exceed kMaxHeldBytes.
  ReversedRows(std::unique_ptr<ByteSource> text, std::int64_t first_line, std::int64_t last_line);

  const std::string& name() const override { return text_->name(); }
  std::uint64_t size() const override { return text_->size(); }
  std::size_t read(std::span<char> into) override;
  void rewind() override;
  ByteSource& file() override { return file_ ? file_->file() : text_->file(); }

  static constexpr std::size_t kMaxHeldBytes = std::size_t{1} << 28;

 private:
  void find_lines(std::int64_t first_line, std::int64_t last_line);
  std::size_t read_forward(std::span<char> into, std::uint64_t end);
  bool fill();
  void append_reversed(std::string_view lines);

  std::unique_ptr<ByteSource> text_, file_;  ///< file_: what a held text is from
  std::uint64_t begin_ = 0, end_ = 0;        ///< bytes of the lines
  std::uint64_t at_ = 0;                     ///< of what is given forward
  std::uint64_t left_ = 0;                   ///< end of the lines that are not given yet
  std::string part_;                         ///< end of a line that begins before left_
  std::string ready_;                        ///< lines to give
  std::size_t given_ = 0;                    ///< bytes of them
};

}  // namespace triax::lab
