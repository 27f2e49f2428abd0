// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

namespace triax::sim {

/// An embedded Runge-Kutta pair. Row i of `a` leads to stage i; the row after the last evaluated
/// stage, or the last stage itself, is the result.
struct Tableau {
  static constexpr int kMostStages = 7;
  int evaluations = 0;  ///< stages at which the derivative is needed
  int rows = 0;         ///< of a; the last one is the result
  int order = 0;        ///< of the result; the error estimate is of order − 1
  std::array<std::array<double, kMostStages>, kMostStages + 1> a{};
  std::array<double, kMostStages> error{};  ///< result minus embedded result
};

/// Improved Euler (Heun) with Euler embedded: for the many small increments of a host program.
inline constexpr Tableau kImprovedEuler{
    .evaluations = 2, .rows = 3, .order = 2, .a = {{{}, {1}, {0.5, 0.5}}}, .error = {-0.5, 0.5}};

/// Dormand and Prince (1980): the least work for a path of any accuracy (bench/point).
inline constexpr Tableau kDormandPrince{
    .evaluations = 7,
    .rows = 7,
    .order = 5,
    .a = {{{},
           {1.0 / 5},
           {3.0 / 40, 9.0 / 40},
           {44.0 / 45, -56.0 / 15, 32.0 / 9},
           {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
           {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
           {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}},
    .error = {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525,
              -1.0 / 40}};

/// The pair for a relative tolerance per step: a host that asks for little takes small increments.
constexpr const Tableau& tableau_for(double tolerance) {
  return tolerance < 1e-5 ? kDormandPrince : kImprovedEuler;
}

}  // namespace triax::sim
