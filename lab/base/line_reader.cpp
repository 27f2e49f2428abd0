// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/line_reader.hpp"

#include <algorithm>
#include <cstring>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {
constexpr std::uint64_t kLargestBlock = std::uint64_t{1} << 17;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
}  // namespace

LineReader::LineReader(ByteSource& source)
    : source_(source),
      block_(static_cast<std::size_t>(std::min(kLargestBlock, source.size() + 1))),
      buffer_(2 * block_) {
  source_.rewind();
  fill();
  if (std::string_view(buffer_.data(), end_).starts_with(kByteOrderMark)) {
    begin_ = kByteOrderMark.size();
    taken_ = begin_;
  }
}

bool LineReader::fill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (end_ > kMaxLine_bytes)
    throw BadInput(source_.name(), line_number_ + 1,
                   "the line is longer than 1 MB; expected a text file with one reading per line");
  if (buffer_.size() - end_ < block_) buffer_.resize(buffer_.size() + block_);
  const auto count = source_.read({buffer_.data() + end_, block_});
  if (line_number_ == 0 && std::string_view(buffer_.data(), end_ + count).starts_with("PK\3\4"))
    throw BadInput(source_.name(), 0,
                   "this is a workbook (.xlsx, .ods) or another zip archive, not a text file: save "
                   "the worksheet with the readings as CSV");
  if (std::memchr(buffer_.data() + end_, 0, count) != nullptr)
    throw BadInput(source_.name(), line_number_ + 1,
                   "NUL bytes found at or after this line: this is not a text file; save the "
                   "record as UTF-8 or Windows-1252 text");
  end_ += count;
  return count > 0;
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  const char* newline = nullptr;
  while (true) {
    const char* from = buffer_.data() + begin_ + searched;
    const std::size_t rest = end_ - begin_ - searched;
    newline = rest ? static_cast<const char*>(std::memchr(from, '\n', rest)) : nullptr;
    if (newline) break;
    searched = end_ - begin_;
    if (!fill()) break;
  }
  const char* start = buffer_.data() + begin_;
  cut_off_ = newline == nullptr;
  if (cut_off_ && begin_ == end_) return false;
  std::size_t length = cut_off_ ? end_ - begin_ : static_cast<std::size_t>(newline - start);
  const std::size_t taken = length + (cut_off_ ? 0 : 1);
  begin_ += taken;
  taken_ += taken;
  ++line_number_;
  if (length > 0 && start[length - 1] == '\r') --length;
  line = {start, length};
  return true;
}

}  // namespace triax::lab
