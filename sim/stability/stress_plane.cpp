// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/stress_plane.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace triax::sim {
namespace {

constexpr int kRadial = 2;  // component 3 of a tensor

Vector<Axisymmetric> reduced(const Vector<Tensor>& v) { return {v(0), v(kRadial)}; }

StiffnessForm<Axisymmetric> reduced(const StiffnessForm<Tensor>& form) {
  StiffnessForm<Axisymmetric> plane;
  plane.stiffness << form.stiffness(0, 0), form.stiffness(0, kRadial), form.stiffness(kRadial, 0),
      form.stiffness(kRadial, kRadial);
  plane.nonlinear = form.nonlinear;
  if (form.nonlinear) plane.norm_term = reduced(form.norm_term);
  plane.mechanisms = form.mechanisms;
  plane.hardening = form.hardening;
  for (std::size_t k = 0; k < static_cast<std::size_t>(form.mechanisms); ++k) {
    plane.relaxation[k] = reduced(form.relaxation[k]);
    plane.trigger[k] = reduced(form.trigger[k]);
  }
  return plane;
}
StiffnessForm<Axisymmetric> reduced(const StiffnessForm<Axisymmetric>& form) { return form; }

/// dε₂ as a function of dσ₂ = s at given dσ₁ = a, dσ₃ = b:
/// A + m s + (B + h s²)/|dσ| (INL2), A + m s + B + h |s| (octolinear).
struct AcrossStrain {
  double linear, slope, rest, half, squares;  // A, m, B, h, a² + b²

  double closed() const {
    const double at_zero = linear + rest;
    return -at_zero / (at_zero < 0 ? slope + half : slope - half);
  }
  std::pair<double, double> value_and_slope(double s) const {
    const double norm = std::sqrt(squares + s * s), w = (rest + half * s * s) / norm;
    return {linear + slope * s + w, slope + (2 * half - w / norm) * s / norm};
  }
};

}  // namespace

template <class Space>
StressPlane<Space>::StressPlane(std::shared_ptr<const IncrementalResponse<Space>> response)
    : response_(std::move(response)) {
  if (const auto* form = std::get_if<StiffnessForm<Space>>(&response_->response())) {
    plane_ = reduced(*form);
    control_.emplace(MixedControl<Axisymmetric>::stresses({1, 1}), 1);
  } else {
    const auto& interpolated = std::get<InterpolatedForm<Space>>(response_->response());
    quadratic_ = interpolated.quadratic;
    if constexpr (Space::kSize == 2) {
      compliance_.emplace(interpolated);
    } else {
      const auto plus = interpolated.plus.template topLeftCorner<3, 3>();
      const auto minus = interpolated.minus.template topLeftCorner<3, 3>();
      mean_ = 0.5 * (plus + minus);
      half_ = 0.5 * (plus - minus);
    }
  }
}

template <class Space>
PointRate<Axisymmetric> StressPlane<Space>::stiff(double axial, double radial) const {
  PreparedControl<Axisymmetric> control = *control_;
  control.increment << axial, radial;
  return solve_control<Axisymmetric>(plane_, control, response_->branch(),
                                     Vector<Axisymmetric>::Zero());
}

template <class Space>
std::optional<double> StressPlane<Space>::across(double axial, double radial) const {
  AcrossStrain across{mean_(1, 0) * axial + mean_(1, kRadial) * radial, mean_(1, 1), 0, half_(1, 1),
                      axial * axial + radial * radial};
  // The only answer, and far enough from where there is none.
  const bool simple = std::abs(across.half) < (1 - 1e-9) * across.slope;
  if (!simple) return std::nullopt;
  if (!quadratic_) {
    across.rest = half_(1, 0) * std::abs(axial) + half_(1, kRadial) * std::abs(radial);
    return across.closed();
  }
  across.rest = half_(1, 0) * axial * axial + half_(1, kRadial) * radial * radial;
  double s = -across.linear / across.slope, last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20; ++i) {
    const auto [value, slope] = across.value_and_slope(s);
    if (!(slope > 1e-3 * across.slope)) return std::nullopt;
    const double step = std::abs(value / slope), size = std::sqrt(across.squares + s * s);
    s -= value / slope;
    // Steps that do not shrink any more are round-off.
    if (step <= 1e-15 * size || (step <= 1e-10 * size && step >= 0.5 * last)) return s;
    last = step;
  }
  return std::nullopt;
}

/// Principal strains of principal stresses, as InterpolatedCompliance::strain().
template <class Space>
Eigen::Vector3d StressPlane<Space>::principal_strain(const Eigen::Vector3d& stress) const {
  Eigen::Vector3d w = stress.cwiseAbs();
  if (quadratic_) w = stress.cwiseAbs2() / stress.norm();
  return mean_ * stress + half_ * w;
}

template <class Space>
typename StressPlane<Space>::Answer StressPlane<Space>::accepted(
    const PointRate<Space>& rate) const {
  const int radial = Space::kSize == 2 ? 1 : kRadial;
  Answer answer{.axial_strain = rate.strain(0), .radial_strain = rate.strain(radial)};
  answer.refused = rate.controllable && response_->law().refusal(response_->state(), rate);
  answer.answered = rate.controllable && !answer.refused;
  return answer;
}

template <class Space>
PointRate<Space> StressPlane<Space>::whole(const PointRate<Axisymmetric>& plane) const {
  if constexpr (Space::kSize == 2) {
    return plane;
  } else {
    const auto& form = std::get<StiffnessForm<Space>>(response_->response());
    PointRate<Space> rate;
    rate.controllable = plane.controllable;
    rate.active = plane.active;
    rate.multiplier = plane.multiplier;
    rate.determinant = plane.determinant;
    rate.strain(0) = plane.strain(0);
    rate.strain(kRadial) = plane.strain(1);
    rate.stress = form.stiffness.col(0) * plane.strain(0);
    rate.stress += form.stiffness.col(kRadial) * plane.strain(1);
    for (std::size_t k = 0; k < kMostMechanisms; ++k)
      if (plane.multiplier[k] != 0) rate.stress -= plane.multiplier[k] * form.relaxation[k];
    if (form.nonlinear) rate.stress -= plane.strain.norm() * form.norm_term;
    return rate;
  }
}

template <class Space>
std::optional<typename StressPlane<Space>::Answer> StressPlane<Space>::to(double axial,
                                                                          double radial) const {
  if (control_) return accepted(whole(stiff(axial, radial)));
  PointRate<Space> rate;
  if constexpr (Space::kSize == 2) {
    rate.stress << axial, radial;
    rate.strain = compliance_->strain(rate.stress);
  } else {
    const auto s = across(axial, radial);
    if (!s) return std::nullopt;
    rate.stress << axial, *s, radial, 0, 0, 0;
    rate.strain.template head<3>() = principal_strain({axial, *s, radial});
  }
  rate.controllable = std::isfinite(rate.strain.sum());
  return accepted(rate);
}

template class StressPlane<Axisymmetric>;
template class StressPlane<Tensor>;

}  // namespace triax::sim
