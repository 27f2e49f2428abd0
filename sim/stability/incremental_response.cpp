// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/incremental_response.hpp"

#include "sim/law/on_yield.hpp"
#include "sim/mechanics/linear_algebra.hpp"
#include "sim/point/finite_driver.hpp"

namespace triax::sim {
namespace {}  // namespace

template <class Space>
IncrementalResponse<Space>::IncrementalResponse(const Law<Space>& law,
                                                const PointState<Space>& state)
    : law_(law), state_(state) {
  law_.response(state_, response_);
  if (const auto* interpolated = std::get_if<InterpolatedForm<Space>>(&response_)) {
    compliance_.emplace(*interpolated);
    modulus_ = 1 / interpolated->plus.diagonal().cwiseAbs().mean();
    return;
  }
  const int mechanisms = std::get<StiffnessForm<Space>>(response_).mechanisms;
  if (mechanisms > 0) {
    law_.settle(state_, mechanisms_on_yield(law_, state_, mechanisms));
    branch_.on_yield =
        mechanisms_on_yield(law_, state_, mechanisms);  // settling may name them anew
    law_.response(state_, response_);
  }
  modulus_ =
      std::max(std::get<StiffnessForm<Space>>(response_).stiffness.diagonal().maxCoeff(), 1e-300);
}

template <class Space>
bool IncrementalResponse<Space>::piecewise_linear() const {
  if (law_.finite()) return false;
  if (const auto* interpolated = std::get_if<InterpolatedForm<Space>>(&response_))
    return !interpolated->quadratic;
  return !std::get<StiffnessForm<Space>>(response_).nonlinear;
}

template <class Space>
PointRate<Space> IncrementalResponse<Space>::accepted(PointRate<Space> rate) const {
  if (rate.controllable && law_.refusal(state_, rate)) {
    rate.controllable = false;
    rate.limiting_variable = kRefused;
  }
  return rate;
}

template <class Space>
PointRate<Space> IncrementalResponse<Space>::solve(const PreparedControl<Space>& control) const {
  return accepted(solve_control<Space>(response_, control, branch_, Vector<Space>::Zero()));
}

template <class Space>
PointRate<Space> IncrementalResponse<Space>::to(const MixedControl<Space>& control) const {
  if (law_.finite()) {
    PointRate<Space> rate = finite_rate(law_, state_, control);
    // At its limit the determinant vanishes; without an answer it is not known.
    if (!rate.controllable && rate.determinant != 0) rate.limiting_variable = kRefused;
    return rate;
  }
  return solve(PreparedControl<Space>(control, modulus_));
}

template <class Space>
PointRate<Space> IncrementalResponse<Space>::to_stress(const Vector<Space>& stress) const {
  if (!compliance_) return to(MixedControl<Space>::stresses(stress));
  PointRate<Space> rate;
  rate.stress = stress;
  rate.strain =
      stress.squaredNorm() > 0 ? compliance_->strain(stress) : Vector<Space>(Vector<Space>::Zero());
  rate.controllable = std::isfinite(rate.strain.sum());
  return accepted(rate);
}

template <class Space>
PointRate<Space> IncrementalResponse<Space>::to_strain(const Vector<Space>& strain) const {
  return to(MixedControl<Space>::strains(strain));
}

/// By differences about the rate's strain, of increments as small as finite_rate takes.
template <class Space>
Matrix<Space> IncrementalResponse<Space>::finite_tangent(const PointRate<Space>& rate) const {
  const double step = 1e-4 * rate.strain.norm();
  Matrix<Space> tangent;
  for (int j = 0; j < Space::kSize; ++j) {
    const Vector<Space> aside = step * Vector<Space>::Unit(j);
    tangent.col(j) =
        (to_strain(rate.strain + aside).stress - to_strain(rate.strain - aside).stress) /
        (2 * step);
  }
  return tangent;
}

template <class Space>
std::optional<Matrix<Space>> IncrementalResponse<Space>::tangent_stiffness(
    const PointRate<Space>& rate) const {
  if (compliance_) return regular_inverse<Space>(compliance_->tangent(rate.stress));
  if (law_.finite()) return finite_tangent(rate);
  const auto& form = std::get<StiffnessForm<Space>>(response_);
  Matrix<Space> tangent = form.stiffness;
  if (form.nonlinear && rate.strain.squaredNorm() > 0)
    tangent -= form.norm_term * rate.strain.normalized().transpose();
  // λ = H⁻¹ m·dε of the mechanisms that load; the others keep λ = 0.
  Eigen::Matrix3d hardening = Eigen::Matrix3d::Identity();
  for (int i = 0; i < form.mechanisms; ++i)
    for (int j = 0; j < form.mechanisms; ++j)
      if ((rate.active >> i & 1U) && (rate.active >> j & 1U))
        hardening(i, j) = form.hardening(i, j);
  const Eigen::Matrix3d softness = hardening.inverse();
  for (unsigned i = 0; i < static_cast<unsigned>(form.mechanisms); ++i)
    for (unsigned j = 0; j < static_cast<unsigned>(form.mechanisms); ++j)
      if ((rate.active >> i & 1U) && (rate.active >> j & 1U))
        tangent -= softness(i, j) * form.relaxation[i] * form.trigger[j].transpose();
  return tangent;
}

template <class Space>
std::optional<Matrix<Space>> IncrementalResponse<Space>::tangent_compliance(
    const PointRate<Space>& rate) const {
  if (compliance_) return compliance_->tangent(rate.stress);
  return regular_inverse<Space>(*tangent_stiffness(rate));
}

template class IncrementalResponse<Axisymmetric>;
template class IncrementalResponse<Tensor>;

}  // namespace triax::sim
