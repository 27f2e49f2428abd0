// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/sanisand_moduli.hpp"

#include <algorithm>
#include <cmath>

namespace triax::sim {
namespace {

SanisandParameters without_fabric(SanisandParameters p) {
  p.fabric_limit = p.fabric_rate = 0;
  return p;
}

/// Unit deviator of triaxial compression along axis 1: taken where the stress itself has none.
template <class Space>
Vector<Space> compression() {
  return deviator<Space>(Vector<Space>::Unit(0)).normalized();
}

}  // namespace

template <class Space>
SanisandModuli<Space>::SanisandModuli(const SanisandParameters& parameters)
    : law_(without_fabric(parameters)) {}

template <class Space>
PointState<Space> SanisandModuli<Space>::start(const Vector<Space>& stress,
                                               double void_ratio) const {
  return {stress, void_ratio, Memory::Zero(2 * kSize + 2)};
}

template <class Space>
std::vector<std::string> SanisandModuli<Space>::memory_names() const {
  std::vector<std::string> all = law_.memory_names();
  std::vector<std::string> names(all.begin() + kSize, all.begin() + 2 * kSize);
  for (int i = 0; i < kSize; ++i)
    names.push_back(std::string(names[static_cast<std::size_t>(i)]).replace(0, 8, "alpha_turn"));
  names.emplace_back("rising");
  names.emplace_back("turning");
  return names;
}

template <class Space>
PointState<Space> SanisandModuli<Space>::standing(const State& state) const {
  const double p = state.p(), radius = kSanisandRoot * law_.parameters().yield_radius;
  Vector<Space> ratio = deviator<Space>(state.stress) / p;
  const double size = ratio.norm();
  const Vector<Space> n = size > 0 ? Vector<Space>(ratio / size) : compression<Space>();
  ratio = std::max(size, 1.001 * radius) * n;
  State s{p * (identity<Space>() + ratio), state.void_ratio, Memory::Zero(3 * kSize)};
  s.memory.template segment<kSize>(0) = ratio - radius * n;
  s.memory.template segment<kSize>(kSize) = state.memory.template head<kSize>();
  return s;
}

template <class Space>
typename Sanisand<Space>::Loading SanisandModuli<Space>::loading(const State& standing) const {
  auto l = law_.loading(standing);
  l.distance = std::abs((law_.alpha(standing) - law_.alpha_in(standing)).dot(l.n));
  return l;
}

template <class Space>
std::optional<std::string> SanisandModuli<Space>::objection(const State& state) const {
  if (!(state.p() > 0)) return "p' is not above 0, where the law ends";
  const State s = standing(state);
  if (auto base = law_.objection(s)) return base;
  if (at_limit(state))
    return "the stress ratio stands on the bounding surface of the base law, where a generalised "
           "triaxial path that raises it has no response";
  return std::nullopt;
}

template <class Space>
bool SanisandModuli<Space>::at_limit(const State& state) const {
  if (!(state.p() > 0)) return false;
  const State s = standing(state);
  const auto l = law_.loading(s);
  return !(l.bounding > law_.alpha(s).dot(l.n));
}

template <class Space>
void SanisandModuli<Space>::moduli(const State& state, Matrix<Space>& plus,
                                   Matrix<Space>& minus) const {
  const State s = standing(state);
  const auto l = loading(s);
  const double modulus =
      2.0 / 3 * s.p() * l.stiffness * (l.bounding - law_.alpha(s).dot(l.n));  // K_p · distance
  const double shear = law_.shear_modulus(state), bulk = law_.bulk_modulus(state);
  // The compliance of isotropic elasticity has the form of its stiffness.
  plus = isotropic_stiffness<Space>(1 / (9 * bulk), 1 / (4 * shear));
  minus = plus;
  for (int j = 0; j < kPrincipalAxes<Space>; ++j) {
    Matrix<Space>& loaded = l.normal(j) > 0 ? plus : minus;
    loaded.col(j) += l.normal(j) * l.distance / modulus * l.direction;
  }
}

/// How far α lies behind the turning point, as a share of the base law's elastic range 2 m; 0 where
/// nothing is turning.
template <class Space>
double SanisandModuli<Space>::gone_back(const State& state) const {
  if (state.memory(kTurning) == 0) return 0;
  const State s = standing(state);
  const Vector<Space> way = law_.alpha(s) - state.memory.template segment<kSize>(kSize);
  const double range = 2 * kSanisandRoot * law_.parameters().yield_radius;
  return -state.memory(kRising) * way.dot(law_.loading(s).n) / range;
}

template <class Space>
bool SanisandModuli<Space>::turn(State& state, const PointRate<Space>& rate) const {
  const State s = standing(state);
  double& rising = state.memory(kRising);
  double& turning = state.memory(kTurning);
  const double back = gone_back(state);
  const bool reversed = back >= 1;
  if (reversed) {
    rising = -rising;
    state.memory.template head<kSize>() = state.memory.template segment<kSize>(kSize);
    turning = 0;
  } else if (back <= 0) {
    turning = 0;
  }
  const double rise = law_.loading(s).normal.dot(rate.stress);
  if (std::abs(rise) <= 1e-9 * rate.stress.norm()) return reversed;
  const double direction = rise > 0 ? 1 : -1;
  if (rising == 0) rising = direction;
  if (direction != rising && turning == 0) {
    turning = 1;
    state.memory.template segment<kSize>(kSize) = law_.alpha(s);
  }
  return reversed;
}

template class SanisandModuli<Axisymmetric>;
template class SanisandModuli<Tensor>;

}  // namespace triax::sim
