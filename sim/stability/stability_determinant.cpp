// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/stability_determinant.hpp"

#include <vector>

#include "sim/stability/plane_rate.hpp"

namespace triax::sim {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;

Eigen::Matrix2d symmetric(const Eigen::Matrix2d& m) { return (m + m.transpose()) / 2; }

/// The unit vector of the direction on (dσ₁, c dσ₃), whose order is that of y and x.
Eigen::Vector2d stress_of(double angle) { return {std::sin(angle), std::cos(angle)}; }

/// M of a direction.
template <class Space>
std::optional<Eigen::Matrix2d> tangent(const IncrementalResponse<Space>& response, double angle) {
  const auto rate = stress_rate(response, angle);
  if (!rate.controllable) return std::nullopt;
  const auto compliance = plane_compliance(response, rate);
  if (!compliance) return std::nullopt;
  return compliance->matrix;
}

/// W₂/|dσ|² around the circle at equal steps; empty entries where there is no answer.
template <class Space>
std::vector<std::optional<double>> works(const IncrementalResponse<Space>& response, int steps) {
  std::vector<std::optional<double>> all;
  for (int i = 0; i < steps; ++i) {
    const auto rate = stress_rate(response, kWholeTurn * i / steps);
    all.push_back(rate.controllable ? std::optional(rate.second_order_work()) : std::nullopt);
  }
  return all;
}

/// From a direction to the nearest that is the least eigenvector of its own H: Newton's method on
/// ∂W₂/∂α = 0 where it is near. Empty where it settles on none.
template <class Space>
std::optional<StabilityDeterminant> own_eigenvector(const IncrementalResponse<Space>& response,
                                                    double angle) {
  for (int i = 0; i < 50; ++i) {
    const auto h = half_hessian(response, angle);
    if (!h) return std::nullopt;
    const double turn = std::remainder(least_direction(*h) - angle, std::numbers::pi);
    if (std::abs(turn) < 1e-8) {
      const double turns = std::floor(angle / kWholeTurn);
      return StabilityDeterminant{relative_determinant(*h), angle - turns * kWholeTurn};
    }
    angle += turn;
  }
  return std::nullopt;
}

}  // namespace

double relative_determinant(const Eigen::Matrix2d& m) {
  const Eigen::Matrix2d s = symmetric(m);
  const double middle = s.trace() / 2, radius = std::hypot((s(0, 0) - s(1, 1)) / 2, s(0, 1));
  const double product = middle + radius < 0 ? -s.determinant() : s.determinant();
  return product / (s.squaredNorm() / 2);
}

double least_direction(const Eigen::Matrix2d& m) {
  const Eigen::Matrix2d s = symmetric(m);
  // vᵗ s v = middle − radius cos 2(α − α₀) with v = (sin α, cos α).
  const double alpha = std::atan2(-2 * s(0, 1), s(0, 0) - s(1, 1)) / 2;
  return alpha < 0 ? alpha + std::numbers::pi : alpha;
}

template <class Space>
std::optional<Eigen::Matrix2d> half_hessian(const IncrementalResponse<Space>& response,
                                            double angle) {
  const auto here = tangent(response, angle);
  if (!here) return std::nullopt;
  if (response.piecewise_linear()) return symmetric(*here);
  const double step = response.law().finite() ? 1e-3 : 1e-5;
  const auto gradient = [&](double at) -> std::optional<Eigen::Vector2d> {
    const auto m = tangent(response, at);
    if (!m) return std::nullopt;
    const Eigen::Vector2d s = stress_of(at);
    return Eigen::Vector2d(symmetric(*m) * s);  // ½ (dε + Mᵗ dσ), dε = M dσ by homogeneity
  };
  const auto centre = gradient(angle), before = gradient(angle - step),
             after = gradient(angle + step);
  if (!centre || !before || !after) return std::nullopt;
  // H v is the gradient and H v⊥ its change with the angle, v⊥ = ∂v/∂α.
  const Eigen::Vector2d v = stress_of(angle), across(std::cos(angle), -std::sin(angle));
  const Eigen::Vector2d change = (*after - *before) / (2 * step);
  return symmetric(*centre * v.transpose() + change * across.transpose());
}

template <class Space>
std::optional<StabilityDeterminant> stability_determinant(
    const IncrementalResponse<Space>& response, int directions) {
  const auto work = works(response, directions);
  const auto n = work.size();
  std::optional<StabilityDeterminant> least;
  for (std::size_t i = 0; i < n; ++i) {
    const auto &before = work[(i + n - 1) % n], &here = work[i], &after = work[(i + 1) % n];
    if (!here || (before && *before < *here) || (after && *after < *here)) continue;
    const auto found = own_eigenvector(response, kWholeTurn * static_cast<double>(i) / directions);
    if (found && (!least || found->value < least->value)) least = found;
  }
  return least;
}

template std::optional<Eigen::Matrix2d> half_hessian(const IncrementalResponse<Axisymmetric>&,
                                                     double);
template std::optional<Eigen::Matrix2d> half_hessian(const IncrementalResponse<Tensor>&, double);
template std::optional<StabilityDeterminant> stability_determinant(
    const IncrementalResponse<Axisymmetric>&, int);
template std::optional<StabilityDeterminant> stability_determinant(
    const IncrementalResponse<Tensor>&, int);

}  // namespace triax::sim
