// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A straight line through weighted points, and where it meets zero.
#include <cstdint>
#include <optional>

namespace triax::lab {

/// Least squares y = a + b x with weights share/σ², in constant memory: only sums are kept.
class StraightLine {
 public:
  struct Zero {
    double x = 0;
    double error = 0;  ///< standard error, from the scatter about the line where that is larger
  };

  /// Adds a point of standard error `sigma` > 0 that is `share` of an independent observation.
  void add(double x, double y, double sigma, double share = 1);
  /// Sum of the shares.
  double independent() const { return shares_; }
  /// Where it meets zero, if it falls towards larger x; empty where it does not, or with fewer than
  /// three points.
  std::optional<Zero> zero() const;

 private:
  std::int64_t points_ = 0;
  double w_ = 0, x_ = 0, y_ = 0;     ///< sum of weights, weighted means
  double xx_ = 0, xy_ = 0, yy_ = 0;  ///< weighted sums of squares about the means
  double shares_ = 0;
};

}  // namespace triax::lab
