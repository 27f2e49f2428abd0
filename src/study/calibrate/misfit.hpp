// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What separates a law with some parameters from the tests.
//
//   r = √(w_k) (computed − measured)/s      at knot k of a quantity of a test
//   cost = Σ r² over the number of series   a series: one quantity of one test, Σ w_k = 1
//
// s is MeasuredPath::scale. So a cost of 1 is a difference of 2 % of the span in every quantity of
// every test, however many readings they have. At a knot that the law did not reach the difference
// is that of its last state, and kRefused is added: the sum falls the further the law comes, so
// that a search finds back inside.
#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "src/study/calibrate/computed_path.hpp"
#include "src/study/calibrate/search_space.hpp"

namespace triax::study {

/// In units of s, at a knot that is not reached.
inline constexpr double kRefused = 30;

/// Of all knots, the first quantity of the test and then the second.
Eigen::VectorXd residuals(const MeasuredPath& measured, const ComputedPath& computed);

/// What came of the tests at some points.
struct Driven {
  Eigen::MatrixXd residuals;  ///< of all tests, one column a point
  /// Whether the law came to the path's end: a row a test, a column a point.
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> whole;
};

/// Drives the law of each point through the tests, on several threads.
class Misfit {
 public:
  /// `space` and `paths` must outlive it. `threads` 0: all cores.
  Misfit(const SearchSpace& space, const std::vector<MeasuredPath>& paths, int threads,
         DrivingOptions driving);

  /// Σ r² of one point, which has to be possible; stops once it is above `enough`. For one thread.
  double sum_of_squares(const Unknowns& x, double enough) const;
  /// Residuals of all tests, one column a point. Points have to be possible.
  Eigen::MatrixXd residuals_of(const std::vector<Unknowns>& points) const {
    return driven(points).residuals;
  }
  /// The same, with where the law came to the end.
  Driven driven(const std::vector<Unknowns>& points) const;
  /// Calls work(i) for i below `count` on all threads.
  void each(std::size_t count, const std::function<void(std::size_t)>& work) const;

  const SearchSpace& space() const { return space_; }
  const std::vector<MeasuredPath>& paths() const { return paths_; }
  double series() const { return 2 * static_cast<double>(paths_.size()); }
  const DrivingOptions& driving() const { return driving_; }
  /// Rows of a test in residuals_of: the first, and how many.
  std::pair<Eigen::Index, Eigen::Index> rows(std::size_t path) const;
  /// Paths driven so far, by all threads.
  std::int64_t runs() const { return runs_; }
  int threads() const { return threads_; }

 private:
  const SearchSpace& space_;
  const std::vector<MeasuredPath>& paths_;
  int threads_;
  DrivingOptions driving_;
  mutable std::atomic<std::int64_t> runs_ = 0;
};

}  // namespace triax::study
