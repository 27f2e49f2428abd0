// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/interpolated.hpp"
#include "sim/materials/sanisand_moduli.hpp"
#include "tests/sim/materials/parameter_sets.hpp"

// INL2 and octolinear with the sets S28-general, as their tests use them.
namespace triax::sim::test {

inline SanisandParameters with_h0(double h0) {
  SanisandParameters p = s28_general();
  p.hardening_factor = h0;
  return p;
}

inline constexpr double kInl2 = 1.996, kOcto = 3.004;

template <class Space>
Interpolated<Space> law(Interpolation kind, double h0) {
  return {kind, std::make_shared<SanisandModuli<Space>>(with_h0(h0))};
}
inline Interpolated<Axisymmetric> inl2() { return law<Axisymmetric>(Interpolation::inl2, kInl2); }
inline Interpolated<Axisymmetric> octo() {
  return law<Axisymmetric>(Interpolation::octolinear, kOcto);
}

inline PointState<Axisymmetric> state_at(const Law<Axisymmetric>& material, double p_kPa,
                                         double eta, double e) {
  const double q = eta * p_kPa;
  return material.start(
      components(AxisymmetricStress{1e3 * (p_kPa + 2 * q / 3), 1e3 * (p_kPa - q / 3)}), e);
}

inline InterpolatedForm<Axisymmetric> moduli(const Law<Axisymmetric>& material,
                                             const PointState<Axisymmetric>& s) {
  return std::get<InterpolatedForm<Axisymmetric>>(material.response(s));
}

}  // namespace triax::sim::test
