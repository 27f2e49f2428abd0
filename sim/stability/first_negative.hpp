#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

namespace triax::sim {

/// Where a value that is ≥ 0 at `in` and < 0 at `out` becomes negative, by Ridders' method: each
/// pair of evaluations at least halves the bracket, whatever the value does (a jump too), and near
/// a simple zero the estimate converges quadratically. `value(x)` is empty where it is unknown, and
/// so is the result then.
template <class Value>
std::optional<double> first_negative(double in, double value_in, double out, double value_out,
                                     double precision, const Value& value) {
  std::optional<double> last;
  for (int i = 0; i < 200; ++i) {
    const double middle = in + (out - in) / 2;
    if (std::abs(out - in) <= precision || middle == in || middle == out) return middle;
    const std::optional<double> at_middle = value(middle);
    if (!at_middle) return std::nullopt;
    const double root = std::sqrt(*at_middle * *at_middle - value_in * value_out);
    const double guess = root > 0 ? middle + (middle - in) * (*at_middle / root) : middle;
    const std::optional<double> at_guess = guess == middle ? at_middle : value(guess);
    if (!at_guess) return std::nullopt;
    if (last && std::abs(guess - *last) <= precision) return guess;
    last = guess;
    for (const auto& [x, v] : {std::pair(middle, *at_middle), std::pair(guess, *at_guess)}) {
      const bool between = (x - in) * (out - x) > 0;
      if (!between) continue;
      (v < 0 ? out : in) = x;
      (v < 0 ? value_out : value_in) = v;
    }
  }
  return in + (out - in) / 2;
}

}  // namespace triax::sim
