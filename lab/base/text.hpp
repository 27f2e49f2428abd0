// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text as laboratories write it: two encodings, blanks in odd places, keys typed almost right.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

bool is_utf8(std::string_view bytes);
/// Bytes of Windows-1252 as UTF-8; the five bytes that code page leaves open become U+FFFD.
std::string utf8_from_cp1252(std::string_view bytes);

/// Without blanks, tabs, and no-break spaces at both ends.
std::string_view trimmed(std::string_view text);
/// For comparing names: trimmed, runs of blanks as one, ASCII letters in lower case.
std::string folded(std::string_view text);
/// The text in single quotes for a message: UTF-8, no control characters, cut after 40 bytes or so.
std::string excerpt(std::string_view text);

/// The number that the text is from its first character to its last, with a decimal point; empty
/// for anything else: blanks, a leading +, a number beyond its type. Number is int, std::int64_t,
/// std::uint64_t or double ("inf" and "nan" are some).
template <class Number>
std::optional<Number> whole_text_as(std::string_view text);

/// The candidate with the fewest typing errors (insert, delete, replace, swap) from `word`; empty
/// where none is near enough to be meant: one error and another for every three letters, or a part
/// of the candidate.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);
/// For messages: "must be one of: A, B"; "none is defined" without candidates.
std::string must_be_one_of(const std::vector<std::string>& candidates);
/// For the message about an unknown word: "did you mean 'NEAREST'? (must be one of: A, B)" or
/// must_be_one_of().
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);
/// "'WORD' is not valid; " and the suggestion.
std::string invalid_value(std::string_view word, const std::vector<std::string>& candidates);
/// Empty words are left out.
std::string joined(const std::vector<std::string>& words, std::string_view between = ", ");

}  // namespace triax::lab
