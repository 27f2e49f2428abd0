// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/stress_plane.hpp"

#include <catch2/catch.hpp>

#include "sim/stability/domain.hpp"
#include "sim/stability/probe.hpp"
#include "tests/sim/stability/domain_laws.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

MixedControl<Axisymmetric> imposed(double axial, double radial, const Axisymmetric&) {
  return MixedControl<Axisymmetric>::stresses({axial, radial});
}
MixedControl<Tensor> imposed(double axial, double radial, const Tensor&) {
  MixedControl<Tensor> control;
  control.stress(0, 0) = control.stress(2, 2) = 1;
  control.increment << axial, 0, radial, 0, 0, 0;
  for (const int fixed : {1, 3, 4, 5}) control.strain(fixed, fixed) = 1;
  return control;
}

/// Directions in which the plane agrees with the solver of all components.
template <class Space>
int check(const Law<Space>& law, double p, double eta, double void_ratio) {
  constexpr int kRadial = Space::kSize == 2 ? 1 : 2;
  const auto state = law.start(domain_stress<Space>(p, eta * p), void_ratio);
  if (law.objection(state)) return 0;
  const auto response = std::make_shared<const IncrementalResponse<Space>>(law, state);
  const StressPlane<Space> plane(response);
  int answered = 0;
  for (int i = 0; i < 72; ++i) {
    const PlaneVector v = unit_direction(2 * std::numbers::pi * (i + 0.1) / 72);
    const auto found = plane.to(v.y(), v.x());
    const auto rate = response->to(imposed(v.y(), v.x(), Space()));
    INFO("p " << p << " eta " << eta << " direction " << i);
    if (!found) continue;
    CHECK(found->answered == rate.controllable);
    CHECK(found->refused == (!rate.controllable && rate.limiting_variable == kRefused));
    if (!rate.controllable || !found->answered) continue;
    const PlaneVector strain(rate.strain(kRadial), rate.strain(0));
    CHECK((PlaneVector(found->radial_strain, found->axial_strain) - strain).norm() <
          1e-10 * strain.norm());
    ++answered;
  }
  return answered;
}

}  // namespace

TEST_CASE("the plane of stress probes answers as the solver of all components does") {
  for (const auto& [name, material, void_ratio] : domain_laws()) {
    INFO(name);
    int answered = 0;
    for (const double eta : {-0.5, 0.0, 0.4, 0.8, 1.1, 1.3})
      for (const double p : {40e3, 200e3}) {
        answered += check(*material.axisymmetric, p, eta, void_ratio);
        if (material.tensor) answered += check(*material.tensor, p, eta, void_ratio);
      }
    CHECK(answered > 500);
  }
}

TEST_CASE("in plane strain no strain across is left over") {
  const auto material = law<Tensor>(Interpolation::octolinear, kOcto);
  const auto response = std::make_shared<const IncrementalResponse<Tensor>>(
      material, material.start(domain_stress<Tensor>(100e3, 60e3), 1.0));
  const StressPlane<Tensor> plane(response);
  const auto& form = std::get<InterpolatedForm<Tensor>>(response->response());
  for (int i = 0; i < 16; ++i) {
    const PlaneVector v = unit_direction(0.3 + i);
    const auto found = plane.to(v.y(), v.x());
    REQUIRE(found);
    // dσ₂ from the zone's row 2, and with it dε₁ from row 1.
    const auto side = [&](int row, int j, double sign) {
      return sign > 0 ? form.plus(row, j) : form.minus(row, j);
    };
    double across = 0;
    for (const double sign : {1.0, -1.0}) {
      const double s = -(side(1, 0, v.y()) * v.y() + side(1, 2, v.x()) * v.x()) / side(1, 1, sign);
      if (s * sign > 0) across = s;
    }
    const double axial =
        side(0, 0, v.y()) * v.y() + side(0, 1, across) * across + side(0, 2, v.x()) * v.x();
    CHECK(found->axial_strain == Approx(axial).epsilon(1e-12));
  }
}
