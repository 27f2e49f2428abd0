// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Paths, states and directions that the tests of hypoplasticity share.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "sim/materials/hypoplastic.hpp"
#include "sim/point/point_driver.hpp"

namespace triax::sim::test {

using HypoplasticState = PointState<Axisymmetric>;

inline HypoplasticState run(const Hypoplastic<Axisymmetric>& law, const HypoplasticState& from,
                            const MixedControl<Axisymmetric>& control) {
  const auto step = advance_point(law, from, control);
  REQUIRE(step.outcome == StepOutcome::accepted);
  return step.state;
}

/// First state on the path at which `ahead` no longer holds of the rate, isolated by halving.
template <class Ahead>
HypoplasticState first_without(const Hypoplastic<Axisymmetric>& law, HypoplasticState state,
                               const MixedControl<Axisymmetric>& increment, Ahead ahead) {
  for (int i = 0; i < 2000; ++i) {
    const HypoplasticState next = run(law, state, increment);
    if (ahead(point_rate(law, next, increment))) {
      state = next;
      continue;
    }
    double low = 0, high = 1;
    HypoplasticState at = state;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      MixedControl<Axisymmetric> part = increment;
      part.increment *= middle;
      at = run(law, state, part);
      (ahead(point_rate(law, at, increment)) ? low : high) = middle;
    }
    return at;
  }
  FAIL("no such state on the path");
  return state;
}

inline HypoplasticState undrained_peak(const Hypoplastic<Axisymmetric>& law, double p0_kPa,
                                       double e) {
  return first_without(
      law, law.isotropic(p0_kPa * 1e3, e), MixedControl<Axisymmetric>::strain_path(2e-4),
      [](const auto& rate) { return deviator_stress<Axisymmetric>(rate.stress) > 0; });
}

inline double eta(const HypoplasticState& state) { return state.q() / state.p(); }

struct HostunTest {
  double p0_kPa, e;
};
// Table 2 of Darve et al. (2007): ICU 6, 42, 7; CSD 51, 58, 60; CSU 31, 26, 41, 27.
inline const std::vector<HostunTest> kHostunTests = {
    {100, 1.086}, {300, 1.060}, {750, 1.083}, {100, 1.192}, {300, 1.068},
    {300, 1.161}, {100, 1.136}, {300, 1.070}, {300, 1.101}, {750, 1.136}};

template <class Space>
PointRate<Space> strained(const Law<Space>& law, const PointState<Space>& state,
                          const Vector<Space>& rate) {
  return point_rate(law, state, MixedControl<Space>::strains(rate));
}

class Dice {
 public:
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Eigen::Matrix3d turn() {
    return Eigen::Quaterniond(normal_(engine_), normal_(engine_), normal_(engine_),
                              normal_(engine_))
        .normalized()
        .toRotationMatrix();
  }
  template <class Space>
  Vector<Space> direction() {
    return Vector<Space>::NullaryExpr([this] { return normal_(engine_); }).normalized();
  }
  PointState<Tensor> state(const Hypoplastic<Tensor>& law) {
    const Eigen::Matrix3d q = turn();
    const Eigen::Vector3d principal((*this)(30e3, 400e3), (*this)(30e3, 400e3),
                                    (*this)(30e3, 400e3));
    auto s = law.start(components(Eigen::Matrix3d(q * principal.asDiagonal() * q.transpose())),
                       (*this)(0.62, 1.2));
    if (law.has_intergranular_strain())
      s.memory = law.parameters().intergranular_range * (*this)(0.1, 1) * direction<Tensor>();
    return s;
  }

 private:
  std::mt19937 engine_{11};
  std::normal_distribution<double> normal_;
};

}  // namespace triax::sim::test
