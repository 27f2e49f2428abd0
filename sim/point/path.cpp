// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/path.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace triax::sim {
namespace {

constexpr double kModulus = 1e7;  // Pa: weighs stress against strain where only rank matters
constexpr std::size_t kMostSegments = 1'000'000;

/// Row of S and E side by side, of length one; zero if there is nothing in it.
template <class Space>
Eigen::Matrix<double, 1, 2 * Space::kSize> direction(const MixedControl<Space>& c, int row) {
  Eigen::Matrix<double, 1, 2 * Space::kSize> both;
  both << c.stress.row(row), c.strain.row(row) / kModulus;
  return both.stableNormalized();
}

/// The first row that follows from those before it; −1 where all are independent.
template <class Space>
int dependent_row(const MixedControl<Space>& c) {
  Eigen::MatrixXd rows(0, 2 * Space::kSize);
  for (int row = 0; row < Space::kSize; ++row) {
    rows.conservativeResize(row + 1, Eigen::NoChange);
    rows.row(row) = direction(c, row);
    Eigen::FullPivLU<Eigen::MatrixXd> lu(rows);
    lu.setThreshold(1e-9);
    if (lu.rank() != row + 1) return row;
  }
  return -1;
}

/// The condition from which the pore pressure follows, or −1.
template <class Space>
int pore_pressure_row(const MixedControl<Space>& c) {
  int best = -1;
  double best_share = 0;
  for (int row = 0; row < Space::kSize; ++row) {
    const auto both = direction(c, row);
    const double share =
        std::abs(both.template head<Space::kSize>().transpose().dot(identity<Space>()));
    if (share < 1e-9) continue;
    const bool held = c.increment(row) == 0;
    const bool best_held = best >= 0 && c.increment(best) == 0;
    if (best >= 0 && (held == best_held ? share <= best_share : best_held)) continue;
    best = row;
    best_share = share;
  }
  return best;
}

template <class Space>
void eliminate_pore_pressure(EffectiveControl<Space>& effective) {
  MixedControl<Space>& c = effective.control;
  const int row = pore_pressure_row(c);
  if (row < 0)
    throw std::invalid_argument(
        "undrained needs one condition on a total stress, e.g. radial_stress_kPa = 0 for a "
        "constant cell pressure");
  const double weight = c.stress.row(row).transpose().dot(identity<Space>());
  effective.undrained = true;
  effective.pore_pressure = c.increment(row) / weight;
  effective.pore_pressure_stress = c.stress.row(row).transpose() / weight;
  effective.pore_pressure_strain = c.strain.row(row).transpose() / weight;
  for (int other = 0; other < Space::kSize; ++other) {
    if (other == row) continue;
    const double share = c.stress.row(other).transpose().dot(identity<Space>());
    // A deviatoric row stays as it is to the bit.
    if (std::abs(share) <= 1e-14 * c.stress.row(other).norm()) continue;
    c.stress.row(other) -= share * effective.pore_pressure_stress.transpose();
    c.strain.row(other) -= share * effective.pore_pressure_strain.transpose();
    c.increment(other) -= share * effective.pore_pressure;
  }
  c.stress.row(row).setZero();
  c.strain.row(row) = identity<Space>().transpose();
  c.increment(row) = 0;
  effective.labels[static_cast<std::size_t>(row)] = "volumetric_strain = 0 (undrained)";
}

}  // namespace

template <class Space>
double EffectiveControl<Space>::pore_pressure_change(double fraction, const Vector<Space>& stress,
                                                     const Vector<Space>& strain) const {
  return fraction * pore_pressure - pore_pressure_stress.dot(stress) -
         pore_pressure_strain.dot(strain);
}

template <class Space>
EffectiveControl<Space> effective_control(const Segment<Space>& segment) {
  EffectiveControl<Space> effective{.control = segment.conditions, .labels = segment.labels};
  effective.labels.resize(Space::kSize);
  for (std::size_t i = 0; i < Space::kSize; ++i)
    if (effective.labels[i].empty()) effective.labels[i] = "condition " + std::to_string(i + 1);
  const auto refuse_dependent = [&](const char* because) {
    const int row = dependent_row(effective.control);
    if (row >= 0)
      throw std::invalid_argument("the condition on " +
                                  effective.labels[static_cast<std::size_t>(row)] + " " + because);
  };
  refuse_dependent("follows from the conditions before it");
  if (!segment.undrained) return effective;
  eliminate_pore_pressure(effective);
  refuse_dependent("contradicts the others and volumetric_strain = 0, which undrained implies");
  return effective;
}

Segment<Tensor> as_tensor_segment(const Segment<Axisymmetric>& segment) {
  Segment<Tensor> lifted;
  lifted.name = segment.name;
  lifted.conditions = as_tensor(segment.conditions);
  lifted.labels = segment.labels;
  lifted.labels.resize(2);
  const bool stresses = segment.conditions.strain.isZero(0);
  lifted.labels.emplace_back(stresses ? "stress_22_kPa - stress_33_kPa" : "strain_22 - strain_33");
  for (const char* component : {"strain_12", "strain_13", "strain_23"})
    lifted.labels.emplace_back(component);
  lifted.undrained = segment.undrained;
  lifted.rows = segment.rows;
  lifted.end = segment.end;
  lifted.repeat = segment.repeat;
  lifted.repeat_from = segment.repeat_from;
  lifted.goes_on = segment.goes_on;
  lifted.least_parts = segment.least_parts;
  return lifted;
}

template <class Space>
std::vector<std::size_t> segment_order(const Path<Space>& path) {
  std::vector<std::size_t> order;
  std::vector<int> passes(path.segments.size(), 0);
  for (std::size_t i = 0; i < path.segments.size();) {
    order.push_back(i);
    if (order.size() > kMostSegments)
      throw std::invalid_argument("more than a million segments with all repetitions");
    const Segment<Space>& segment = path.segments[i];
    if (++passes[i] < segment.repeat) {
      i = std::min(segment.repeat_from.value_or(i), i);
    } else {
      passes[i] = 0;  // a loop around this one begins it anew
      ++i;
    }
  }
  return order;
}

template struct EffectiveControl<Axisymmetric>;
template struct EffectiveControl<Tensor>;
template EffectiveControl<Axisymmetric> effective_control(const Segment<Axisymmetric>&);
template EffectiveControl<Tensor> effective_control(const Segment<Tensor>&);
template std::vector<std::size_t> segment_order(const Path<Axisymmetric>&);
template std::vector<std::size_t> segment_order(const Path<Tensor>&);

}  // namespace triax::sim
