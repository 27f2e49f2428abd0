// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::lab {

/// Finds where a noisy value turns negative for good: Page's cumulative sum. The sum runs only
/// below zero; where it last stood at zero is the most likely place of the change, and how far it
/// has fallen, in standard errors, says whether there was one.
class ChangePoint {
 public:
  /// Standard errors from which a change counts. The sum starts again at every return to zero, so
  /// there are many tries in a long test: five, where a single look would ask for three.
  static constexpr double kSignificance = 5;

  /// An error from which a value in [−1, 1] tells nothing and is passed over.
  static constexpr double kUseless = 0.5;

  /// Adds a value, weighed by its precision 1/error²; `weight` is its share of an independent
  /// observation (windows overlap). Returns true where the sum stands at zero: no change yet.
  bool add(double value, double error, double weight);
  /// True once the sum has run for a whole independent observation.
  bool lasted() const { return weight_ >= 1; }
  /// True once it has lasted and its fall is significant.
  bool found() const;
  void clear() { *this = ChangePoint(); }

 private:
  double sum_ = 0;
  double precision_ = 0;
  double weight_ = 0;
};

}  // namespace triax::lab
