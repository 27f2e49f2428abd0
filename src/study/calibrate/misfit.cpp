// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/misfit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace triax::study {
namespace {

/// The laws of one point, made when a path asks for them: one for all paths where it can be, since
/// that of a plug-in costs a process.
class Laws {
 public:
  Laws(const SearchSpace& space, const Unknowns& x) : space_(space), x_(x) {}
  const sim::Law<sim::Axisymmetric>* of(Imposed imposed) {
    auto& made = made_[imposed == Imposed::undrained && space_.drainage_matters() ? 0 : 1];
    if (!made) made = space_.material(x_, imposed).value_or(sim::Material{});
    return made->axisymmetric.get();
  }

 private:
  const SearchSpace& space_;
  const Unknowns& x_;
  std::array<std::optional<sim::Material>, 2> made_;
};

ComputedPath nowhere(const MeasuredPath& path) {
  ComputedPath none;
  none.last = path.start;
  none.refusal = "the law rejects the parameters";
  return none;
}

ComputedPath along(const MeasuredPath& path, Laws& laws, const DrivingOptions& driving) {
  const auto* law = laws.of(path.imposed);
  return law == nullptr ? nowhere(path) : drive(*law, path, driving);
}

}  // namespace

Eigen::VectorXd residuals(const MeasuredPath& measured, const ComputedPath& computed) {
  const auto count = static_cast<Eigen::Index>(measured.knots.size());
  const auto quantities = compared_in(measured.imposed);
  Eigen::VectorXd r(2 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto u = static_cast<std::size_t>(k);
    const PathKnot& at = measured.knots[u];
    const bool reached = u < computed.knots.size();
    const PathKnot& found = reached ? computed.knots[u] : computed.last;
    // Of the knot under way the part that is done counts, so that the sum changes steadily.
    const double missing =
        reached ? 0 : std::clamp(static_cast<double>(u) + 1 - computed.reached, 0.0, 1.0);
    for (std::size_t j = 0; j < 2; ++j) {
      const double difference =
          (found.value(quantities[j]) - at.value(quantities[j])) / measured.scale[j];
      const double bounded = reached ? difference : std::clamp(difference, -kRefused, kRefused);
      const double refused = std::copysign(kRefused * missing, bounded);
      r(static_cast<Eigen::Index>(j) * count + k) = std::sqrt(at.weight) * (bounded + refused);
    }
  }
  return r;
}

Misfit::Misfit(const SearchSpace& space, const std::vector<MeasuredPath>& paths, int threads,
               DrivingOptions driving)
    : space_(space),
      paths_(paths),
      threads_(threads > 0 ? threads
                           : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))),
      driving_(driving) {}

double Misfit::sum_of_squares(const Unknowns& x, double enough) const {
  Laws laws(space_, x);
  double sum = 0;
  for (const MeasuredPath& path : paths_) {
    sum += residuals(path, along(path, laws, driving_)).squaredNorm();
    ++runs_;
    if (sum > enough) break;
  }
  return sum;
}

std::pair<Eigen::Index, Eigen::Index> Misfit::rows(std::size_t path) const {
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < path; ++i)
    first += 2 * static_cast<Eigen::Index>(paths_[i].knots.size());
  return {first, 2 * static_cast<Eigen::Index>(paths_[path].knots.size())};
}

Driven Misfit::driven(const std::vector<Unknowns>& points) const {
  const auto [before_last, last] = rows(paths_.size() - 1);
  const auto columns = static_cast<Eigen::Index>(points.size());
  Driven found{Eigen::MatrixXd(before_last + last, columns),
               {static_cast<Eigen::Index>(paths_.size()), columns}};
  each(points.size() * paths_.size(), [&](std::size_t task) {
    const std::size_t point = task / paths_.size(), path = task % paths_.size();
    const auto column = static_cast<Eigen::Index>(point);
    const auto [first, count] = rows(path);
    Laws laws(space_, points[point]);
    const ComputedPath computed = along(paths_[path], laws, driving_);
    found.residuals.col(column).segment(first, count) = residuals(paths_[path], computed);
    found.whole(static_cast<Eigen::Index>(path), column) =
        computed.knots.size() == paths_[path].knots.size();
    ++runs_;
  });
  return found;
}

void Misfit::each(std::size_t count, const std::function<void(std::size_t)>& work) const {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < std::min(count, static_cast<std::size_t>(threads_)); ++t)
      others.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace triax::study
