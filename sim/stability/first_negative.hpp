// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <optional>

namespace triax::sim {

/// Where a value that is ≥ 0 at `in` and < 0 at `out` becomes negative, by Ridders' method: near a
/// simple zero the estimate converges quadratically, and each turn at least halves the bracket,
/// whatever the value does. An estimate that stands still is believed only once the sign is seen to
/// change within `precision` of it, so that a jump is found too. `value(x)` is empty where it is
/// unknown, and so is the result then.
template <class Value>
std::optional<double> first_negative(double in, double value_in, double out, double value_out,
                                     double precision, const Value& value) {
  const double outwards = out > in ? precision : -precision;
  std::optional<double> last;
  for (int i = 0; i < 200; ++i) {
    const double middle = in + (out - in) / 2;
    if (std::abs(out - in) <= precision || middle == in || middle == out) return middle;
    const auto note = [&](double x, double v) {
      if (!((x - in) * (out - x) > 0)) return;
      (v < 0 ? out : in) = x;
      (v < 0 ? value_out : value_in) = v;
    };
    const std::optional<double> at_middle = value(middle);
    if (!at_middle) return std::nullopt;
    const double root = std::sqrt(*at_middle * *at_middle - value_in * value_out);
    const double guess = root > 0 ? middle + (middle - in) * (*at_middle / root) : middle;
    const std::optional<double> at_guess = guess == middle ? at_middle : value(guess);
    if (!at_guess) return std::nullopt;
    note(middle, *at_middle);
    note(guess, *at_guess);
    if (last && std::abs(guess - *last) <= precision) {
      const double beside = *at_guess < 0 ? guess - outwards : guess + outwards;
      const std::optional<double> at_beside = value(beside);
      if (!at_beside) return std::nullopt;
      if ((*at_beside < 0) != (*at_guess < 0)) return guess;
      note(beside, *at_beside);
    }
    last = guess;
  }
  return in + (out - in) / 2;
}

}  // namespace triax::sim
