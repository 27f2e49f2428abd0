// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr double kRounding = 1e-9;  // of a step: what binary fractions may leave of the last one

[[noreturn]] void fail(std::string_view text, const std::string& why) {
  throw std::invalid_argument(excerpt(text) + ' ' + why);
}

double number(std::string_view part, std::string_view text) {
  const auto value = whole_text_as<double>(trimmed(part));
  if (!value || !std::isfinite(*value))
    fail(text, "is not a range; expected FROM:TO:STEP or FROM:TO/COUNT, as in 1.0:1.2:0.02");
  return *value;
}

int decimals(std::string_view text) {
  constexpr int kVeryMany = 100;
  if (text.find_first_of("eE") != std::string_view::npos) return kVeryMany;
  const auto point = text.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

Range by_step(Range range, double step, std::string_view text, std::int64_t most) {
  const double steps = (range.to - range.from) / step;
  if (!(steps >= 0) || !std::isfinite(steps))
    fail(text, fmt::format("cannot reach {1:g} from {0:g} in steps of {2:g}", range.from, range.to,
                           step));
  if (steps >= static_cast<double>(most)) fail(text, fmt::format("has more than {} values", most));
  range.step = step;
  range.count = static_cast<std::int64_t>(std::floor(steps + kRounding)) + 1;
  return range;
}

Range by_count(Range range, std::string_view part, std::string_view text, std::int64_t most) {
  const auto count = whole_text_as<std::int64_t>(trimmed(part));
  if (!count || *count < 1)
    fail(text, "is not a range; expected an integer after the '/', as in 10:300/200");
  if (*count > most) fail(text, fmt::format("has more than {} values", most));
  range.count = *count;
  return range;
}

}  // namespace

double Range::at(std::int64_t place) const {
  if (step) return from + static_cast<double>(place) * *step;
  if (place + 1 == count && count > 1) return to;
  return from + static_cast<double>(place) * (to - from) /
                    static_cast<double>(std::max<std::int64_t>(1, count - 1));
}

bool Range::meets_end() const {
  if (count == 1) return from == to;
  return std::abs(at(count - 1) - to) <= kRounding * std::abs(to - from);
}

bool looks_like_range(std::string_view text) { return text.find(':') != std::string_view::npos; }

Range read_range(std::string_view text, std::int64_t most) {
  constexpr auto kNone = std::string_view::npos;
  const auto first = text.find(':'), second = text.find_first_of(":/", first + 1);
  // number() says what is expected where a separator is missing or superfluous.
  if (first == kNone || second == kNone) number("", text);
  const auto end_text = text.substr(first + 1, second - first - 1), last = text.substr(second + 1);
  Range range;
  range.from = number(text.substr(0, first), text);
  range.to = number(end_text, text);
  if (text[second] == ':')
    range.decimals = std::max(decimals(text.substr(0, first)), decimals(last));
  if (text[second] == ':') return by_step(range, number(last, text), text, most);
  return by_count(range, last, text, most);
}

std::vector<std::string> written_values(const Range& range) {
  constexpr int kMostDigits = 15;
  std::vector<std::string> values;
  for (std::int64_t i = 0; i < range.count; ++i)
    if (!range.step)
      values.push_back(fmt::format("{:.12g}", range.at(i)));
    else
      values.push_back(range.decimals > kMostDigits
                           ? fmt::format("{}", range.at(i))
                           : fmt::format("{:.{}f}", range.at(i), range.decimals));
  return values;
}

}  // namespace triax::lab
