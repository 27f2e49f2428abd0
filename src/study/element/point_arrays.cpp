// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/point_arrays.hpp"

#include <algorithm>
#include <numbers>

namespace triax::study {
namespace {

constexpr double kKilo = 1e3;
constexpr std::size_t kMostMessages = 100;
constexpr std::size_t kBetweenStops = 1000;

/// Orthonormal components over those of the tensor.
template <class Space>
sim::Vector<Space> scale() {
  if constexpr (Space::kSize == 2)
    return {1, std::numbers::sqrt2};
  else
    return (sim::Vector<Space>() << 1, 1, 1, std::numbers::sqrt2, std::numbers::sqrt2,
            std::numbers::sqrt2)
        .finished();
}

template <class Space>
using Row = Eigen::Map<sim::Vector<Space>>;
template <class Space>
using ConstRow = Eigen::Map<const sim::Vector<Space>>;

template <class Space>
sim::PointState<Space> state_of(const PointArrays& points, std::size_t i) {
  const Eigen::Map<const Eigen::VectorXd> memory(points.memory.data() + i * points.memories,
                                                 static_cast<Eigen::Index>(points.memories));
  return {
      kKilo * scale<Space>().cwiseProduct(ConstRow<Space>(&points.stress_kPa[i * Space::kSize])),
      points.void_ratio[i], memory};
}

template <class Space>
void put(const sim::PointState<Space>& state, PointArrays& points, std::size_t i) {
  Row<Space>(&points.stress_kPa[i * Space::kSize]) =
      state.stress.cwiseQuotient(kKilo * scale<Space>());
  points.void_ratio[i] = state.void_ratio;
  std::copy_n(state.memory.data(), points.memories, points.memory.data() + i * points.memories);
}

template <class Space>
void put(const sim::PointStep<Space>& step, StepArrays& steps, std::size_t i) {
  steps.outcome[i] = static_cast<std::uint8_t>(step.outcome);
  steps.done[i] = step.done;
  steps.error[i] = step.error;
  Row<Space>(&steps.stress_kPa[i * Space::kSize]) =
      step.stress_increment.cwiseQuotient(kKilo * scale<Space>());
  Row<Space>(&steps.strain[i * Space::kSize]) = step.strain_increment.cwiseQuotient(scale<Space>());
  const double norms = step.stress_increment.norm() * step.strain_increment.norm();
  steps.work_kPa[i] = step.second_order_work() / kKilo;
  steps.work_normalised[i] = norms > 0 ? step.second_order_work() / norms : 0;
  if (!step.message.empty() && steps.messages.size() < kMostMessages)
    steps.messages.emplace_back(i, step.message);
}

}  // namespace

template <class Space>
PointArrays start_points(const sim::Law<Space>& law, std::vector<double> stress_kPa,
                         std::vector<double> void_ratio) {
  PointArrays points{.count = void_ratio.size(),
                     .components = Space::kSize,
                     .memories = 0,
                     .stress_kPa = std::move(stress_kPa),
                     .void_ratio = std::move(void_ratio),
                     .memory = {}};
  for (std::size_t i = 0; i < points.count; ++i) {
    const ConstRow<Space> stress(&points.stress_kPa[i * Space::kSize]);
    const auto state = law.start(kKilo * scale<Space>().cwiseProduct(stress), points.void_ratio[i]);
    if (i == 0) {
      points.memories = static_cast<std::size_t>(state.memory.size());
      points.memory.resize(points.count * points.memories);
    }
    put(state, points, i);
  }
  return points;
}

template <class Space>
StepArrays advance_points(const sim::Law<Space>& law, const PointConditions<Space>& conditions,
                          const sim::PointTolerance& tolerance, PointArrays& points,
                          const std::function<bool()>& stop) {
  const std::size_t n = points.count, size = Space::kSize;
  StepArrays steps;
  steps.outcome.resize(n, static_cast<std::uint8_t>(sim::StepOutcome::failed));
  steps.done.resize(n);
  steps.error.resize(n);
  steps.stress_kPa.resize(n * size);
  steps.strain.resize(n * size);
  steps.work_kPa.resize(n);
  steps.work_normalised.resize(n);
  sim::MixedControl<Space> control;
  control.stress = conditions.stress * (kKilo * scale<Space>()).cwiseInverse().asDiagonal();
  control.strain = conditions.strain * scale<Space>().cwiseInverse().asDiagonal();
  const std::size_t stride = conditions.rows.size() == size ? 0 : size;
  for (std::size_t i = 0; i < n; ++i) {
    if (i % kBetweenStops == 0 && stop && stop()) {
      steps.stopped_at = i;
      return steps;
    }
    control.increment = ConstRow<Space>(&conditions.rows[i * stride]);
    const auto step = sim::advance_point(law, state_of<Space>(points, i), control, tolerance);
    put(step.state, points, i);
    put(step, steps, i);
  }
  steps.stopped_at = n;
  return steps;
}

// clang-format off
template PointArrays start_points(const sim::Law<sim::Axisymmetric>&, std::vector<double>, std::vector<double>);
template PointArrays start_points(const sim::Law<sim::Tensor>&, std::vector<double>, std::vector<double>);
template StepArrays advance_points(const sim::Law<sim::Axisymmetric>&, const PointConditions<sim::Axisymmetric>&,
                                   const sim::PointTolerance&, PointArrays&, const std::function<bool()>&);
template StepArrays advance_points(const sim::Law<sim::Tensor>&, const PointConditions<sim::Tensor>&,
                                   const sim::PointTolerance&, PointArrays&, const std::function<bool()>&);
// clang-format on

}  // namespace triax::study
