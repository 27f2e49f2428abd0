// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/least_squares.hpp"

#include <ceres/tiny_solver.h>

#include <cmath>
#include <limits>

namespace triax::study {
namespace {

constexpr double kOutside = 0.02;  // of a range: as bad as one unit of a residual
constexpr double kForwardStep = 3e-4;

struct Stopped {};

Eigen::VectorXd prior_residuals(const SearchSpace& space, const Unknowns& x) {
  Eigen::VectorXd r = Eigen::VectorXd::Zero(space.size());
  for (Eigen::Index i = 0; i < space.size(); ++i)
    if (const auto& prior = space.ranges()[static_cast<std::size_t>(i)].prior)
      r(i) = (space.value(i, x(i)) - prior->value) / prior->error;
  return r;
}

/// Rows of one point: tests (of its possible neighbour), bounds, priors.
Eigen::VectorXd all_rows(const SearchSpace& space, const Eigen::VectorXd& tests, const Unknowns& x,
                         const Unknowns& possible) {
  const Eigen::Index m = tests.size(), n = space.size();
  Eigen::VectorXd r(m + 2 * n);
  r << tests, (x - possible) / kOutside, prior_residuals(space, possible);
  return r;
}

/// What TinySolver asks for.
class Problem {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  Problem(const Misfit& misfit, const std::function<bool()>& go_on)
      : misfit_(misfit), go_on_(go_on) {}
  int NumResiduals() const {
    const auto [first, count] = misfit_.rows(misfit_.paths().size() - 1);
    return static_cast<int>(first + count + 2 * misfit_.space().size());
  }
  int NumParameters() const { return static_cast<int>(misfit_.space().size()); }

  bool operator()(const double* parameters, double* residuals, double* jacobian) const {
    if (!go_on_()) throw Stopped{};
    const SearchSpace& space = misfit_.space();
    const Eigen::Index n = space.size();
    const Unknowns x = Eigen::Map<const Unknowns>(parameters, n);
    std::vector<Unknowns> points = {x};
    // Forward; backward where the upper bound is near.
    const auto step = [&](Eigen::Index i) {
      return x(i) + kForwardStep > 1 ? -kForwardStep : kForwardStep;
    };
    if (jacobian != nullptr)
      for (Eigen::Index i = 0; i < n; ++i) {
        points.push_back(x);
        points.back()(i) += step(i);
      }
    std::vector<Unknowns> possible;
    possible.reserve(points.size());
    for (const Unknowns& point : points) possible.push_back(space.possible_near(point));
    const Eigen::MatrixXd tests = misfit_.residuals_of(possible);
    const auto rows = [&](std::size_t k) {
      return all_rows(space, tests.col(static_cast<Eigen::Index>(k)), points[k], possible[k]);
    };
    const Eigen::VectorXd r = rows(0);
    Eigen::Map<Eigen::VectorXd>(residuals, r.size()) = r;
    note(possible.front(), r);
    if (jacobian == nullptr) return true;
    Eigen::Map<Eigen::MatrixXd> slopes(jacobian, r.size(), n);
    for (Eigen::Index i = 0; i < n; ++i)
      slopes.col(i) = (rows(static_cast<std::size_t>(i) + 1) - r) / step(i);
    return true;
  }

  const LocalOptimum& best() const { return best_; }

 private:
  void note(const Unknowns& possible, const Eigen::VectorXd& r) const {
    const Eigen::Index n = misfit_.space().size();
    const double sum = r.head(r.size() - 2 * n).squaredNorm() + r.tail(n).squaredNorm();
    if (best_.x.size() == 0 || sum < best_.sum) best_ = {possible, sum, best_.iterations};
    ++best_.iterations;
  }

  const Misfit& misfit_;
  const std::function<bool()>& go_on_;
  mutable LocalOptimum best_;
};

}  // namespace

Residuals residuals_with_slopes(const Misfit& misfit, const Unknowns& x, double step) {
  const SearchSpace& space = misfit.space();
  std::vector<Unknowns> points = {x};
  for (Eigen::Index i = 0; i < x.size(); ++i)
    for (const double side : {step, -step}) {
      points.push_back(x);
      points.back()(i) += side;
      // A side that is not possible counts as none; the other one remains.
      if (points.back()(i) > 1 || points.back()(i) < 0 || !space.possible(points.back()))
        points.back() = x;
    }
  const Driven driven = misfit.driven(points);
  const auto rows = [&](std::size_t k) {
    return all_rows(space, driven.residuals.col(static_cast<Eigen::Index>(k)), points[k],
                    points[k]);
  };
  Residuals found{rows(0), {}};
  found.jacobian.setZero(found.values.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto up = static_cast<std::size_t>(2 * i + 1), down = up + 1;
    const Eigen::VectorXd above = rows(up), below = rows(down);
    const double to_above = points[up](i) - x(i), to_below = x(i) - points[down](i);
    auto slopes = found.jacobian.col(i);
    if (to_above + to_below > 0) slopes = (above - below) / (to_above + to_below);
    for (std::size_t t = 0; t < misfit.paths().size(); ++t) {
      const auto whole = driven.whole.row(static_cast<Eigen::Index>(t));
      const bool upwards = whole(2 * i + 1);
      if (!whole(0) || upwards == whole(2 * i + 2)) continue;
      const double width = upwards ? to_above : to_below;
      if (width == 0) continue;
      const auto [first, count] = misfit.rows(t);
      const Eigen::VectorXd change = upwards ? above - found.values : found.values - below;
      slopes.segment(first, count) = change.segment(first, count) / width;
    }
  }
  return found;
}

LocalOptimum least_squares(const Misfit& misfit, const Unknowns& from, int most_iterations,
                           const std::function<bool()>& go_on) {
  const Problem problem(misfit, go_on);
  ceres::TinySolver<Problem> solver;
  solver.options.max_num_iterations = most_iterations;
  solver.options.gradient_tolerance = 1e-9;
  solver.options.parameter_tolerance = 1e-7;
  solver.options.function_tolerance = 1e-9;
  solver.options.cost_threshold = 1e-12;
  Unknowns x = from;
  try {
    solver.Solve(problem, &x);
  } catch (const Stopped&) {
    // The best until then.
  }
  if (problem.best().x.size() == 0)
    return {misfit.space().possible_near(from), std::numeric_limits<double>::infinity(), 0};
  return problem.best();
}

}  // namespace triax::study
