// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/reversed_rows.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/base/line_reader.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kReverseBlock = std::size_t{1} << 16;

/// A copy in memory.
std::unique_ptr<ByteSource> held(ByteSource& text) {
  std::string bytes;
  std::vector<char> block(kReverseBlock);
  text.rewind();
  while (const std::size_t count = text.read(block)) {
    bytes.append(block.data(), count);
    if (bytes.size() > ReversedRows::kMaxHeldBytes)
      throw BadInput(text.name(), 0,
                     "the rows are in reverse order and too many for a file that is no plain UTF-8 "
                     "text: sort them, or save the table as CSV in UTF-8");
  }
  return open_memory(text.name(), std::move(bytes));
}

}  // namespace

ReversedRows::ReversedRows(std::unique_ptr<ByteSource> text, std::int64_t first_line,
                           std::int64_t last_line)
    : text_(std::move(text)) {
  if (!text_->is_seekable()) {
    file_ = std::move(text_);
    text_ = held(*file_);
  }
  find_lines(first_line, last_line);
  rewind();
}

void ReversedRows::find_lines(std::int64_t first_line, std::int64_t last_line) {
  std::vector<char> block(kReverseBlock);
  std::uint64_t at = 0;
  std::int64_t line = 1;
  bool is_begun = first_line <= 1, is_found = false;
  text_->rewind();
  while (const std::size_t count = text_->read(block)) {
    for (const char c : std::span(block).first(count)) {
      ++at;
      if (c != '\n' || is_found) continue;
      ++line;
      if (line == first_line) begin_ = at;
      is_begun = is_begun || line == first_line;
      is_found = line == last_line + 1;
      if (is_found) end_ = at;
    }
  }
  if (!is_found) end_ = at;
  if (!is_begun) begin_ = end_;
}

void ReversedRows::rewind() {
  text_->rewind();
  at_ = 0;
  left_ = end_;
  part_.clear();
  ready_.clear();
  given_ = 0;
}

std::size_t ReversedRows::read_forward(std::span<char> into, std::uint64_t end) {
  const auto wanted = std::min<std::uint64_t>(into.size(), end - at_);
  const std::size_t count = text_->read(into.first(static_cast<std::size_t>(wanted)));
  at_ += count;
  return count;
}

/// Lines in the order of the file, the last one first. A block begins inside a line.
void ReversedRows::append_reversed(std::string_view lines) {
  while (!lines.empty()) {
    const auto before = lines.rfind('\n');
    if (before == std::string_view::npos) break;
    ready_.append(lines.substr(before + 1)).append(part_).push_back('\n');
    part_.clear();
    lines = lines.substr(0, before);
  }
  part_.insert(0, lines);
}

/// The next block of lines; false if all are given.
bool ReversedRows::fill() {
  ready_.clear();
  given_ = 0;
  while (ready_.empty() && left_ > begin_) {
    const auto count =
        static_cast<std::size_t>(std::min<std::uint64_t>(kReverseBlock, left_ - begin_));
    std::string block(count, '\0');
    text_->rewind();
    text_->skip(left_ - count);
    std::size_t taken = 0;
    while (taken < count) {
      const std::size_t more = text_->read(std::span(block).subspan(taken));
      if (more == 0) throw WorkFailed(name() + ": became shorter while it was read");
      taken += more;
    }
    const bool is_last = left_ == end_;
    left_ -= count;
    std::string_view lines = block;
    if (is_last && lines.ends_with('\n')) lines.remove_suffix(1);
    append_reversed(lines);
    if (part_.size() > kMaxLine_bytes)
      throw BadInput(name(), 0, "a line is too long for a row of readings");
    if (left_ == begin_) ready_.append(std::exchange(part_, {})).push_back('\n');
  }
  return !ready_.empty();
}

std::size_t ReversedRows::read(std::span<char> into) {
  if (at_ < begin_) return read_forward(into, begin_);
  if (at_ == begin_ && at_ < end_) {
    if (given_ == ready_.size() && !fill()) {
      text_->rewind();
      text_->skip(end_);
      at_ = end_;
    } else {
      const std::size_t count = std::min(into.size(), ready_.size() - given_);
      std::copy_n(ready_.data() + given_, count, into.data());
      given_ += count;
      return count;
    }
  }
  return read_forward(into, size());
}

}  // namespace triax::lab
