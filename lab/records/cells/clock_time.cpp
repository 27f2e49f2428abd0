// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/clock_time.hpp"

#include <array>
#include <charconv>
#include <chrono>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr double kDay = 86400;

/// Three numbers kept apart by `mark`, all of `text`.
std::optional<std::array<int, 3>> three_numbers(std::string_view text, char mark) {
  std::array<int, 3> out{};
  const char* at = text.data();
  const char* end = at + text.size();
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i > 0 && (at == end || *at++ != mark)) return std::nullopt;
    const auto [stop, error] = std::from_chars(at, end, out[i]);
    if (error != std::errc{} || out[i] < 0) return std::nullopt;
    at = stop;
  }
  return at == end ? std::optional(out) : std::nullopt;
}

std::optional<double> day_seconds(std::string_view text) {
  namespace ch = std::chrono;
  auto n = three_numbers(text, '-');
  if (!n)
    for (const char mark : {'.', '/'})
      if (!n && (n = three_numbers(text, mark))) std::swap((*n)[0], (*n)[2]);
  if (!n) return std::nullopt;
  const ch::year_month_day date{ch::year{(*n)[0]}, ch::month{static_cast<unsigned>((*n)[1])},
                                ch::day{static_cast<unsigned>((*n)[2])}};
  if (!date.ok() || (*n)[0] < 1900) return std::nullopt;
  return static_cast<double>(ch::sys_days{date}.time_since_epoch().count()) * kDay;
}

std::optional<double> time_of_day(std::string_view text) {
  const auto first = text.find(':');
  if (first == std::string_view::npos || first == 0 || first > 2) return std::nullopt;
  const auto second = text.find(':', first + 1);
  const auto hours = whole_text_as<int>(text.substr(0, first));
  const auto minutes = whole_text_as<int>(text.substr(first + 1, second - first - 1));
  const auto seconds = second == std::string_view::npos
                           ? std::optional(0.0)
                           : whole_text_as<double>(text.substr(second + 1));
  if (!hours || !minutes || !seconds) return std::nullopt;
  const bool shown = *hours >= 0 && *hours < 24 && *minutes >= 0 && *minutes < 60 &&
                     *seconds >= 0 && *seconds < 61;
  return shown ? std::optional(*hours * 3600.0 + *minutes * 60.0 + *seconds) : std::nullopt;
}

}  // namespace

std::optional<double> clock_seconds(std::string_view text) {
  text = trimmed(text);
  const auto gap = text.find_first_of(" T");
  if (gap == std::string_view::npos) return time_of_day(text);
  const auto day = day_seconds(text.substr(0, gap));
  const auto time = time_of_day(trimmed(text.substr(gap + 1)));
  return day && time ? std::optional(*day + *time) : std::nullopt;
}

double Clock::since_start(double seconds) {
  if (!first_) first_ = last_ = seconds;
  const bool dated = *first_ > kDay;
  if (!dated && seconds < last_ - kDay / 2) days_ += kDay;
  last_ = seconds;
  return seconds + days_ - *first_;
}

}  // namespace triax::lab
