// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/asking/text_answer.hpp"

#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/wire/exchange.hpp"

namespace triax::lab {

double spoken_number(std::string_view text) {
  constexpr double kOverload = 9.9e37, kNoNumber = 9.91e37;
  auto digits = trimmed(text);
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  const bool letters = digits.find_first_not_of("+-.0123456789eE") != std::string_view::npos;
  const auto number = letters ? std::nullopt : whole_text_as<double>(digits);
  if (!number) throw Malformed(fmt::format("no number: {}", excerpt(text)));
  if (*number == kNoNumber) return std::numeric_limits<double>::quiet_NaN();
  if (std::abs(*number) >= kOverload)
    return std::copysign(std::numeric_limits<double>::infinity(), *number);
  return *number;
}

std::vector<double> spoken_numbers(std::string_view text, std::size_t count,
                                   std::string_view no_value) {
  std::vector<double> numbers;
  std::string_view rest = text.substr(0, text.find_last_not_of("\r\n") + 1);
  for (bool more = true; more;) {
    const auto end = rest.find_first_of(",;\r\n");
    const auto word = trimmed(rest.substr(0, end));
    const bool none = !no_value.empty() && word == no_value;
    numbers.push_back(none ? std::numeric_limits<double>::quiet_NaN() : spoken_number(word));
    more = end != std::string_view::npos;
    if (more) rest.remove_prefix(end + (rest.substr(end).starts_with("\r\n") ? 2 : 1));
  }
  if (numbers.size() != count)
    throw Malformed(
        fmt::format("{} numbers instead of {}: {}", numbers.size(), count, excerpt(text)));
  return numbers;
}

namespace {

constexpr std::size_t kStampFields = 6;

/// Seconds since 1970 of year, month, day, hour, minute, second.
double calendar_s(const double* fields, std::string_view text) {
  const auto whole = [&](std::size_t i, double least, double most) {
    if (!(fields[i] >= least && fields[i] <= most) || std::floor(fields[i]) != fields[i])
      throw Malformed(fmt::format("not a date and time: {}", excerpt(text)));
    return static_cast<unsigned>(fields[i]);
  };
  using namespace std::chrono;
  const year_month_day date{year(static_cast<int>(whole(0, 1970, 9999))), month(whole(1, 1, 12)),
                            day(whole(2, 1, 31))};
  const double minutes = whole(3, 0, 23) * 60 + whole(4, 0, 59);
  if (!date.ok() || !(fields[5] >= 0 && fields[5] < 61))
    throw Malformed(fmt::format("not a date and time: {}", excerpt(text)));
  return duration<double>(sys_days(date).time_since_epoch()).count() + minutes * 60 + fields[5];
}

}  // namespace

StampedNumbers stamped_numbers(std::string_view text, std::size_t count,
                               std::string_view no_value) {
  constexpr std::size_t kFields = 1 + kStampFields;
  const std::vector<double> all = spoken_numbers(text, count * kFields, no_value);
  StampedNumbers stamped;
  for (std::size_t i = 0; i < all.size(); i += kFields) {
    stamped.numbers.push_back(all[i]);
    const double at_s = calendar_s(&all[i + 1], text);
    if (i == 0) stamped.first_s = at_s;
  }
  return stamped;
}

std::size_t whole_lines(std::string_view received, int lines, char end) {
  constexpr std::size_t kLongest = 65536;
  for (std::size_t i = 0; i < received.size(); ++i) {
    const char c = received[i];
    const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    if (control && c != '\r' && c != '\n' && c != '\t')
      throw Malformed(
          fmt::format("a byte that is not text: {:#04x}", static_cast<unsigned char>(c)));
    if (c == end && --lines == 0) return i + 1;
  }
  if (received.size() > kLongest) throw Malformed("64 KB without the end of a line");
  return 0;
}

}  // namespace triax::lab
