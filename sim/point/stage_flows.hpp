// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The derivatives at the stages of one Runge-Kutta step of a material point, and what follows from
// them: the states of the rows of the tableau and the estimated error.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "sim/law/law.hpp"
#include "sim/point/runge_kutta.hpp"

namespace triax::sim {

/// The derivative of everything that is integrated, per increment.
template <class Space>
struct StageFlow {
  Vector<Space> stress, strain;
  double void_ratio = 0;
  Memory memory;
};

template <class Space>
class StageFlows {
 public:
  /// Stress (Pa) below which errors are not measured relative to p′.
  static constexpr double kSmallestStress = 0.1;

  /// The tableau must outlive it; the law gives the size of each of the `memories`.
  StageFlows(const Tableau& tableau, const Law<Space>& law, Eigen::Index memories)
      : tableau_(tableau), scale_(memories) {
    for (int k = 0; k < scale_.size(); ++k) scale_(k) = 1 / law.memory_scale(k);
  }

  StageFlow<Space>& operator[](int stage) { return flows_[static_cast<std::size_t>(stage)]; }

  /// State and strain of a row of the tableau: x = x₀ + h Σ a_j ẋ_j, with h the `fraction` of the
  /// increment. Pre-condition: the flows of the stages before it are known.
  void move(const PointState<Space>& from, double fraction, int row, PointState<Space>& at,
            Vector<Space>& strain) const {
    std::array<double, Tableau::kMostStages> weight{};
    const int columns = std::min(row, tableau_.evaluations);
    at.stress = from.stress;
    at.void_ratio = from.void_ratio;
    strain.setZero();
    for (std::size_t j = 0; j < static_cast<std::size_t>(columns); ++j) {
      weight[j] = fraction * tableau_.a[static_cast<std::size_t>(row)][j];
      if (weight[j] == 0) continue;
      at.stress += weight[j] * flows_[j].stress;
      at.void_ratio += weight[j] * flows_[j].void_ratio;
      strain += weight[j] * flows_[j].strain;
    }
    at.memory = from.memory;
    for (std::size_t j = 0; j < static_cast<std::size_t>(columns); ++j)
      if (flows_[j].memory.size() > 0) at.memory += weight[j] * flows_[j].memory;
  }

  /// Largest estimated error h |Σ e_j ẋ_j| of a step that ends at `at`: of stress relative to p′,
  /// of strain and void ratio to 1, of each memory to its size.
  double error_at(const PointState<Space>& at, double fraction) const {
    Vector<Space> stress = Vector<Space>::Zero(), strain = stress;
    double void_ratio = 0, worst = 0;
    for (int i = 0; i < tableau_.evaluations; ++i) {
      const double weight = fraction * tableau_.error[static_cast<std::size_t>(i)];
      stress += weight * flows_[static_cast<std::size_t>(i)].stress;
      strain += weight * flows_[static_cast<std::size_t>(i)].strain;
      void_ratio += weight * flows_[static_cast<std::size_t>(i)].void_ratio;
    }
    Memory memory;
    for (std::size_t i = 0; i < static_cast<std::size_t>(tableau_.evaluations); ++i) {
      if (flows_[i].memory.size() == 0) continue;
      if (memory.size() == 0) memory.setZero(at.memory.size());
      memory += tableau_.error[i] * flows_[i].memory;
    }
    if (memory.size() > 0) worst = memory.cwiseProduct(scale_).cwiseAbs().maxCoeff();
    worst *= fraction;
    const double size = std::max(std::abs(at.p()), kSmallestStress);
    return std::max({worst, stress.cwiseAbs().maxCoeff() / size, strain.cwiseAbs().maxCoeff(),
                     std::abs(void_ratio)});
  }

 private:
  const Tableau& tableau_;
  Memory scale_;  // 1/size of each entry of the memory
  std::array<StageFlow<Space>, Tableau::kMostStages> flows_;
};

}  // namespace triax::sim
