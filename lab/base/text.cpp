// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <limits>

namespace triax::lab {
namespace {

// 0x80..0x9F of Windows-1252; 0 where the code page has no character.
constexpr std::array<std::uint16_t, 32> kCp1252{
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

void append_utf8(std::string& out, std::uint32_t code) {
  const auto push = [&](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
  if (code < 0x80) {
    push(code);
  } else if (code < 0x800) {
    push(0xC0 | (code >> 6));
    push(0x80 | (code & 0x3F));
  } else {
    push(0xE0 | (code >> 12));
    push(0x80 | ((code >> 6) & 0x3F));
    push(0x80 | (code & 0x3F));
  }
}

std::uint8_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<std::uint8_t>(text[i]);
}

// Length of the well-formed UTF-8 sequence at i, 0 if there is none.
std::size_t sequence_length(std::string_view text, std::size_t i) {
  const auto first = byte_at(text, i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte_at(text, i + k) & 0xC0) != 0x80) return 0;
  const auto second = byte_at(text, i + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool no_character = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return overlong || no_character ? 0 : length;
}

std::size_t typing_errors(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto length = sequence_length(bytes, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

std::string utf8_from_cp1252(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size() + 8);
  for (const char c : bytes) {
    const auto byte = static_cast<std::uint8_t>(c);
    if (byte < 0x80 || byte > 0x9F) {
      append_utf8(out, byte);
    } else {
      const auto code = kCp1252[byte - 0x80U];
      append_utf8(out, code ? code : 0xFFFDU);
    }
  }
  return out;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kNoBreakSpace = "\xC2\xA0";
  while (true) {
    const auto size = text.size();
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
      text.remove_suffix(1);
    if (text.starts_with(kNoBreakSpace)) text.remove_prefix(2);
    if (text.ends_with(kNoBreakSpace)) text.remove_suffix(2);
    if (text.size() == size) return text;
  }
}

std::string folded(std::string_view text) {
  std::string out;
  for (const char c : trimmed(text)) {
    const bool blank = c == ' ' || c == '\t';
    if (blank && !out.empty() && out.back() == ' ') continue;
    const char letter = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    out.push_back(blank ? ' ' : letter);
  }
  return out;
}

namespace {

/// Control characters above ASCII, blanks that do not break, soft hyphens, characters without width
/// and marks of reading order, as one character of UTF-8.
bool is_invisible(std::string_view character) {
  if (character.size() == 2 && character[0] == '\xC2')
    return character[1] <= '\xA0' || character[1] == '\xAD';
  if (character.starts_with("\xE2\x80"))
    return character[2] <= '\x8F' || (character[2] >= '\xA8' && character[2] <= '\xAF');
  return character == "\xEF\xBB\xBF";
}

}  // namespace

std::string excerpt(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  const std::string utf8 =
      is_utf8(text) ? std::string(text) : utf8_from_cp1252(text.substr(0, 2 * kLongest));
  std::string out = "'";
  for (std::size_t i = 0; i < utf8.size();) {
    if (i >= kLongest) return out + "...'";
    const auto length = std::max<std::size_t>(sequence_length(utf8, i), 1);
    const auto first = byte_at(utf8, i);
    if (first < 0x20 || first == 0x7F || is_invisible(utf8.substr(i, length)))
      out += '?';
    else
      out.append(utf8, i, length);
    i += length;
  }
  return out + "'";
}

template <class Number>
std::optional<Number> whole_text_as(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}
template std::optional<int> whole_text_as(std::string_view);
template std::optional<std::int64_t> whole_text_as(std::string_view);
template std::optional<std::uint64_t> whole_text_as(std::string_view);
template std::optional<double> whole_text_as(std::string_view);

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  // Longer words are no misspelt keys, and would cost time to compare.
  constexpr std::size_t kLongest = 64;
  constexpr std::size_t kShortestPart = 3;
  if (word.size() > kLongest) return {};
  const std::string wanted = folded(word);
  std::string best;
  auto fewest = std::numeric_limits<std::size_t>::max();
  for (const auto& candidate : candidates) {
    const auto known = folded(candidate);
    const auto errors = typing_errors(wanted, known);
    const bool part = wanted.size() >= kShortestPart && known.find(wanted) != std::string::npos;
    if (errors >= fewest || (errors > 1 + wanted.size() / 3 && !part)) continue;
    fewest = errors;
    best = candidate;
  }
  return best;
}

std::string must_be_one_of(const std::vector<std::string>& candidates) {
  return candidates.empty() ? "none is defined" : "must be one of: " + joined(candidates);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
  const auto near = nearest(word, candidates);
  const auto accepted = must_be_one_of(candidates);
  return near.empty() ? accepted : "did you mean '" + near + "'? (" + accepted + ")";
}

std::string invalid_value(std::string_view word, const std::vector<std::string>& candidates) {
  return excerpt(word) + " is not valid; " + suggestion(word, candidates);
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  std::string out;
  for (const auto& word : words) {
    if (word.empty()) continue;
    if (!out.empty()) out += between;
    out += word;
  }
  return out;
}

}  // namespace triax::lab
