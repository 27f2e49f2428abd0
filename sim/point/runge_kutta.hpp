#pragma once
#include <array>

namespace triax::sim {

/// An embedded Runge-Kutta pair whose last stage is at the result (first same as last).
struct Tableau {
  static constexpr int kMostStages = 7;
  int stages = 0;
  int order = 0;  ///< of the result; the error estimate is of order − 1
  std::array<std::array<double, kMostStages - 1>, kMostStages> a{};
  std::array<double, kMostStages> error{};  ///< result minus embedded result
};

/// Bogacki and Shampine (1989): cheap steps, for moderate accuracy and many small increments.
inline constexpr Tableau kBogackiShampine{
    .stages = 4,
    .order = 3,
    .a = {{{}, {1.0 / 2}, {0, 3.0 / 4}, {2.0 / 9, 1.0 / 3, 4.0 / 9}}},
    .error = {2.0 / 9 - 7.0 / 24, 1.0 / 3 - 1.0 / 4, 4.0 / 9 - 1.0 / 3, -1.0 / 8}};

/// Dormand and Prince (1980): for high accuracy.
inline constexpr Tableau kDormandPrince{
    .stages = 7,
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

}  // namespace triax::sim
