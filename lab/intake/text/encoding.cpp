// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/encoding.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/text/encoding_odds.hpp"

namespace triax::lab {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::size_t kMaxSequence = 4;  ///< bytes of the longest character

/// The file's first and last bytes.
struct Ends {
  std::string first, last;
};

std::string read_up_to(ByteSource& source, std::size_t count) {
  std::string bytes(count, '\0');
  std::size_t taken = 0;
  while (taken < count) {
    const auto more = source.read({bytes.data() + taken, count - taken});
    if (more == 0) break;
    taken += more;
  }
  bytes.resize(taken);
  return bytes;
}

Ends read_ends(ByteSource& source) {
  source.rewind();
  Ends ends{.first = read_up_to(source, kEncodingSample), .last = {}};
  if (source.size() > ends.first.size()) {
    const auto rest = source.size() - ends.first.size();
    if (rest > kEncodingSample) source.skip(rest - kEncodingSample);
    ends.last = read_up_to(source, kEncodingSample);
  }
  source.rewind();
  return ends;
}

/// UTF-8, but for characters that are cut at the ends.
bool is_cut_utf8(std::string_view bytes, bool cut_front, bool cut_back) {
  const auto is_inner = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  for (std::size_t i = 0; cut_front && i + 1 < kMaxSequence && !bytes.empty(); ++i) {
    if (!is_inner(bytes.front())) break;
    bytes.remove_prefix(1);
  }
  if (is_utf8(bytes)) return true;
  for (std::size_t i = 0; cut_back && i + 1 < kMaxSequence && !bytes.empty(); ++i) {
    const bool inner = is_inner(bytes.back());
    bytes.remove_suffix(1);
    if (!inner) return is_utf8(bytes);
  }
  return false;
}

/// UTF-16 without a mark: every other byte of digits and separators is 0.
std::optional<std::string> find_bare_utf16(std::string_view bytes) {
  constexpr std::size_t kMinShare = 4;   // a quarter of the characters are ASCII
  constexpr std::size_t kMinOther = 50;  // against one character that ends in 0
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < bytes.size(); ++i) zeros[i % 2] += bytes[i] == 0 ? 1 : 0;
  const auto pairs = bytes.size() / 2;
  for (const std::size_t high : {0, 1})
    if (pairs > 1 && kMinShare * zeros[high] >= pairs && kMinOther * zeros[1 - high] <= zeros[high])
      return high == 0 ? "UTF-16BE" : "UTF-16LE";
  return std::nullopt;
}

/// Name in encoding_names() of what a user wrote; nothing for an unknown one.
std::optional<std::string> known_name(const std::string& written) {
  std::string plain = folded(written);
  std::erase_if(plain, [](char c) { return c == '-' || c == '_' || c == ' '; });
  constexpr std::array<std::pair<const char*, const char*>, 8> kOthers{{{"utf16", "UTF-16LE"},
                                                                        {"gbk", "GB18030"},
                                                                        {"gb2312", "GB18030"},
                                                                        {"sjis", "Shift-JIS"},
                                                                        {"cp932", "Shift-JIS"},
                                                                        {"cp949", "EUC-KR"},
                                                                        {"iso88591", "Latin-1"},
                                                                        {"utf8sig", "UTF-8"}}};
  for (const auto& [other, name] : kOthers)
    if (plain == other) return name;
  if (plain.starts_with("cp")) plain = "windows" + plain.substr(2);
  for (const std::string& name : encoding_names()) {
    std::string one = folded(name);
    std::erase(one, '-');
    if (one == plain) return name;
  }
  return std::nullopt;
}

/// As iconv names it.
std::string iconv_name(const std::string& name) {
  if (name == "Shift-JIS") return "CP932";
  if (name == "EUC-KR") return "CP949";
  if (name == "Latin-1") return "ISO-8859-1";
  return name.starts_with("Windows-") ? "CP" + name.substr(std::strlen("Windows-")) : name;
}

}  // namespace

const std::vector<std::string>& encoding_names() {
  static const std::vector<std::string> names{
      "UTF-8",        "UTF-16LE",     "UTF-16BE",     "GB18030",      "Shift-JIS", "EUC-KR",
      "Windows-1250", "Windows-1251", "Windows-1252", "Windows-1254", "Latin-1"};
  return names;
}

Encoding find_encoding(std::string_view first, std::string_view last) {
  Encoding out;
  if (first.starts_with("\xFF\xFE") || first.starts_with("\xFE\xFF")) {
    out.name = first.front() == '\xFF' ? "UTF-16LE" : "UTF-16BE";
    out.has_mark = true;
  } else if (const auto bare = find_bare_utf16(first)) {
    out.name = *bare;
  } else {
    out.has_mark = first.starts_with(kUtf8Mark);
    if (!is_cut_utf8(first, false, !last.empty()) || !is_cut_utf8(last, true, false))
      out.name = find_code_page(first, last);
  }
  const auto has = [&](char c) {
    return first.find(c) != std::string_view::npos || last.find(c) != std::string_view::npos;
  };
  out.has_lone_returns = has('\r') && !has('\n');
  return out;
}

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// The bytes with U+FFFD in place of what is not UTF-8 (iconv lets some of it pass). Keeps the
/// begin of a character at the end of `bytes`, unless the file ends there.
void append_valid_utf8(std::string& bytes, std::string& text, bool at_end) {
  const std::string_view all = bytes;
  std::size_t i = 0;
  while (i < all.size() && (at_end || i + kMaxSequence <= all.size())) {
    std::size_t length = 1;
    while (length < kMaxSequence && !is_utf8(all.substr(i, length))) ++length;
    if (is_utf8(all.substr(i, length))) {
      text.append(all, i, length);
      i += length;
    } else {
      text += kReplacement;
      ++i;
    }
  }
  bytes.erase(0, i);
}

}  // namespace

/// One conversion by iconv, with its state between blocks.
class Utf8Source::Converter {
 public:
  explicit Converter(const std::string& name)
      : from_(name), handle_(iconv_open("UTF-8", iconv_name(name).c_str())) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the value that iconv_open defines for a failure
    if (handle_ == reinterpret_cast<iconv_t>(-1))
      throw WorkFailed("this system cannot convert " + name + " to UTF-8");
  }
  ~Converter() { iconv_close(handle_); }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  void restart() { iconv(handle_, nullptr, nullptr, nullptr, nullptr); }

  /// Appends the bytes to `text` as UTF-8 and keeps in `bytes` the begin of a character that goes
  /// on in the next block; at the end of the file nothing goes on.
  void convert(std::string& bytes, std::string& text, bool at_end) {
    if (from_ == "UTF-8") return append_valid_utf8(bytes, text, at_end);
    std::array<char, 4096> block{};
    char* in = bytes.data();
    std::size_t left = bytes.size();
    while (left > 0) {
      char* out = block.data();
      std::size_t room = block.size();
      const auto done = iconv(handle_, &in, &left, &out, &room);
      const int error = errno;
      text.append(block.data(), block.size() - room);
      if (done != static_cast<std::size_t>(-1) || error == E2BIG) continue;
      if (error == EINVAL && !at_end) break;
      text += kReplacement;
      const auto bad = std::min(left, from_.starts_with("UTF-16") ? std::size_t{2} : 1);
      in += bad;
      left -= bad;
    }
    bytes.erase(0, bytes.size() - left);
  }

 private:
  std::string from_;
  iconv_t handle_;
};

Utf8Source::Utf8Source(std::unique_ptr<ByteSource> original, const Encoding& encoding)
    : original_(std::move(original)),
      encoding_(encoding),
      converter_(std::make_unique<Converter>(encoding.name)) {
  begin();
}
Utf8Source::~Utf8Source() = default;

std::uint64_t Utf8Source::size() const {
  return encoding_.name.starts_with("UTF-16") ? original_->size() / 2 : original_->size();
}

void Utf8Source::rewind() { begin(); }

void Utf8Source::begin() {
  original_->rewind();
  converter_->restart();
  bytes_.clear();
  text_.clear();
  at_ = 0;
  at_end_ = false;
  if (encoding_.has_mark) original_->skip(encoding_.is_utf8() ? kUtf8Mark.size() : 2);
}

bool Utf8Source::fill() {
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  text_.clear();
  at_ = 0;
  while (text_.empty() && !at_end_) {
    const auto kept = bytes_.size();
    bytes_.resize(kept + kBlock);
    const auto count = original_->read({bytes_.data() + kept, kBlock});
    bytes_.resize(kept + count);
    at_end_ = count == 0;
    converter_->convert(bytes_, text_, at_end_);
  }
  if (encoding_.has_lone_returns) std::ranges::replace(text_, '\r', '\n');
  return !text_.empty();
}

std::size_t Utf8Source::read(std::span<char> into) {
  if (at_ == text_.size() && !fill()) return 0;
  const auto count = std::min(into.size(), text_.size() - at_);
  std::copy_n(text_.data() + at_, count, into.data());
  at_ += count;
  return count;
}

std::unique_ptr<ByteSource> open_utf8(std::unique_ptr<ByteSource> source,
                                      const std::optional<std::string>& encoding) {
  const Ends ends = read_ends(*source);
  Encoding found = find_encoding(ends.first, ends.last);
  const bool is_utf8_text = found.is_utf8() && !found.has_lone_returns;
  if (encoding && !encoding->empty()) {
    const auto name = known_name(*encoding);
    if (!name)
      throw BadInput(source->name(), 0, "encoding " + invalid_value(*encoding, encoding_names()));
    const bool same_mark = found.has_mark && name->substr(0, 5) == found.name.substr(0, 5);
    if (!same_mark) {
      found.name = *name;
      found.has_mark = false;
    }
  }
  if (is_utf8_text && found.is_utf8()) return source;
  return std::make_unique<Utf8Source>(std::move(source), found);
}

}  // namespace triax::lab
