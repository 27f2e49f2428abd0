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
  const auto first = all.begin() + kSize;
  std::vector<std::string> names(first, first + kSize);
  for (int i = 0; i < kSize; ++i)
    names.push_back(std::string(names[static_cast<std::size_t>(i)]).replace(0, 8, "alpha_turn"));
  names.emplace_back("rising");
  names.emplace_back("turning");
  return names;
}

template <class Space>
typename Sanisand<Space>::Standing SanisandModuli<Space>::standing(const State& state) const {
  const double radius = kSanisandRoot * law_.parameters().yield_radius;
  typename Sanisand<Space>::Standing s{.p = state.p(), .void_ratio = state.void_ratio};
  const Vector<Space> ratio = deviator<Space>(state.stress) / s.p;
  const double size = ratio.norm();
  s.n = size > 0 ? Vector<Space>(ratio / size) : compression<Space>();
  const double length = std::max(size, 1.001 * radius);
  s.ratio = length * s.n;
  s.along = length - radius;
  return s;
}

template <class Space>
std::optional<std::string> SanisandModuli<Space>::objection(const State& state) const {
  if (!(state.p() > 0)) return "p' is not above 0, where the law ends";
  if (auto base = law_.objection(state.stress, state.void_ratio)) return base;
  if (at_limit(state))
    return "the stress ratio stands on the bounding surface of the base law, where a generalised "
           "triaxial path that raises it has no response";
  return std::nullopt;
}

template <class Space>
bool SanisandModuli<Space>::at_limit(const State& state) const {
  if (!(state.p() > 0)) return false;
  const auto s = standing(state);
  return !(law_.bounding(s) > s.along);
}

template <class Space>
void SanisandModuli<Space>::moduli(const State& state, Matrix<Space>& plus,
                                   Matrix<Space>& minus) const {
  const auto s = standing(state);
  const auto l = law_.loading(s);
  const double distance = std::abs(s.along - state.memory.template head<kSize>().dot(s.n));
  const double modulus = 2.0 / 3 * s.p * l.stiffness * (l.bounding - s.along);  // K_p · distance
  // The compliance of isotropic elasticity has the form of its stiffness.
  plus = isotropic_stiffness<Space>(1 / (9 * (law_.bulk_ratio() * l.shear)), 1 / (4 * l.shear));
  minus = plus;
  const Vector<Space> flow = (distance / modulus) * l.direction;
  for (int j = 0; j < kPrincipalAxes<Space>; ++j) {
    Matrix<Space>& loaded = l.normal(j) > 0 ? plus : minus;
    loaded.col(j) += l.normal(j) * flow;
  }
}

/// How far α lies behind the turning point, as a share of the base law's elastic range 2 m; 0 where
/// nothing is turning.
template <class Space>
double SanisandModuli<Space>::gone_back(const State& state) const {
  if (state.memory(kTurning) == 0) return 0;
  const auto s = standing(state);
  const Vector<Space> way = s.along * s.n - state.memory.template segment<kSize>(kSize);
  const double range = 2 * kSanisandRoot * law_.parameters().yield_radius;
  return -state.memory(kRising) * way.dot(s.n) / range;
}

template <class Space>
bool SanisandModuli<Space>::turn(State& state, const PointRate<Space>& rate) const {
  const auto s = standing(state);
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
  // ∂f/∂σ : dσ
  const double rise = s.n.dot(rate.stress) - s.n.dot(s.ratio) * trace<Space>(rate.stress) / 3;
  if (std::abs(rise) <= 1e-9 * rate.stress.norm()) return reversed;
  const double direction = rise > 0 ? 1 : -1;
  if (rising == 0) rising = direction;
  if (direction != rising && turning == 0) {
    turning = 1;
    state.memory.template segment<kSize>(kSize) = s.along * s.n;
  }
  return reversed;
}

template class SanisandModuli<Axisymmetric>;
template class SanisandModuli<Tensor>;

}  // namespace triax::sim
