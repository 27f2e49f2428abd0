// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words in cells of dates and clocks (clock_words.toml): months in 11 languages, halves of the day,
// marks such as h and 年, eras, time zones.
#include <cstddef>
#include <optional>
#include <string_view>

namespace triax::lab {

enum class ClockWordKind : unsigned char {
  month,        ///< value: 1 to 12
  first_half,   ///< of the day: AM, 上午
  second_half,  ///< PM, 下午
  year_mark,    ///< the number in front of the mark is the year
  month_mark,
  day_mark,
  hour_mark,
  minute_mark,
  second_mark,
  era,   ///< value: years to add to the number that follows
  zone,  ///< value: minutes ahead of UTC
  other  ///< has no meaning: T, at, Uhr, days of the week
};

struct ClockWord {
  ClockWordKind kind = ClockWordKind::other;
  int value = 0;
  std::size_t length = 0;  ///< bytes of the text that the word takes
};

/// The word that `run` (letters only, not empty) is, without regard to letter case and accents; for
/// a run that begins outside ASCII also the longest word at its beginning ("日下午": 日). Empty if
/// there is none.
std::optional<ClockWord> find_clock_word(std::string_view run);

/// The era of a single letter in front of a year ("R8.3.9"), empty for any other letter.
std::optional<int> find_era_letter(char letter);

}  // namespace triax::lab
