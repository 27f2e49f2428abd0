// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How often intervals hold the truth, counted over sets of tests. The parameters of a set come from
// the same noise, so that it is sets that are independent, not parameters:
//
//   p = Σ held/Σ known,  s² = n/(n − 1) Σ (held − p known)²/(Σ known)²   over n sets
#include <algorithm>
#include <cmath>
#include <vector>

namespace triax::bench {

class HeldShare {
 public:
  void add(int held, int known) { sets_.push_back({held, known}); }

  int held() const {
    int sum = 0;
    for (const Set& set : sets_) sum += set.held;
    return sum;
  }
  double share() const { return held() / std::max(1.0, known()); }

  /// No less than that of independent parameters of which 95 % are held: the scatter of a few sets
  /// may be none.
  double standard_error() const {
    const double p = share(), n = static_cast<double>(sets_.size());
    const double of_independent = std::sqrt(0.95 * 0.05 / std::max(1.0, known()));
    if (sets_.size() < 2) return of_independent;
    double squares = 0;
    for (const Set& set : sets_) squares += std::pow(set.held - p * set.known, 2);
    return std::max(of_independent, std::sqrt(n / (n - 1) * squares) / std::max(1.0, known()));
  }

  /// Whether chance explains what the share lies outside of 93 to 97 %: three standard errors.
  bool plausible() const {
    const double outside = std::max({0.93 - share(), share() - 0.97, 0.0});
    return outside <= 3 * standard_error();
  }

 private:
  struct Set {
    int held = 0, known = 0;
  };

  double known() const {
    double sum = 0;
    for (const Set& set : sets_) sum += set.known;
    return sum;
  }

  std::vector<Set> sets_;
};

}  // namespace triax::bench
