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
  return {stress, void_ratio, Memory::Zero(kTurning + 1)};
}

template <class Space>
std::vector<std::string> SanisandModuli<Space>::memory_names() const {
  std::vector<std::string> all = law_.memory_names();
  std::vector<std::string> names(all.begin() + kSize, all.begin() + 2 * kSize);
  for (const char* part : {"ratio_turn", "alpha_in_1", "alpha_in_2", "alpha_in_3"})
    for (std::size_t i = 0; i < kSize; ++i)
      names.push_back(std::string(names[i]).replace(0, std::string_view("alpha_in").size(), part));
  names.emplace_back("interrupted");
  names.emplace_back("turning");
  return names;
}

template <class Space>
typename SanisandModuli<Space>::Standing SanisandModuli<Space>::standing(const State& state) const {
  const auto from = state.memory.template head<kSize>();
  Standing s;
  s.p = state.p();
  s.void_ratio = state.void_ratio;
  const Vector<Space> way = ratio(state) - from;
  const double size = way.norm();
  s.n = size > 0 ? Vector<Space>(way / size) : compression<Space>();
  const double length = std::max(size, 1.001 * radius());
  s.ratio = from + length * s.n;
  s.distance = length - radius();
  s.along = from.dot(s.n) + s.distance;
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
  const double modulus = 2.0 / 3 * s.p * l.stiffness * (l.bounding - s.along);  // K_p · distance
  // The compliance of isotropic elasticity has the form of its stiffness.
  plus = isotropic_stiffness<Space>(1 / (9 * (law_.bulk_ratio() * l.shear)), 1 / (4 * l.shear));
  minus = plus;
  const Vector<Space> flow = (s.distance / modulus) * l.direction;
  for (int j = 0; j < kPrincipalAxes<Space>; ++j) {
    Matrix<Space>& loaded = l.normal(j) > 0 ? plus : minus;
    loaded.col(j) += l.normal(j) * flow;
  }
}

/// How far the stress ratio lies behind the turning point, as a share of the base law's elastic
/// range 2 m; 0 where nothing is turning.
template <class Space>
double SanisandModuli<Space>::gone_back(const State& state, const Standing& s) const {
  if (state.memory(kTurning) == 0) return 0;
  const Vector<Space> way = ratio(state) - state.memory.template segment<kSize>(kSize);
  return -way.dot(s.n) / (2 * radius());
}

/// How far α is from where the loop closes, as the same share; 1 where there is none.
template <class Space>
double SanisandModuli<Space>::left_to_close(const State& state, const Standing& s) const {
  if (state.memory(kOpen) < 2) return 1;
  const Vector<Space> loop = origin(state, 1) - origin(state, 0);
  return (loop.norm() - s.distance) / (2 * radius());
}

/// How far the stress ratio is from coming back through α_in towards the reversal, as the same
/// share; 1 where there was none.
template <class Space>
double SanisandModuli<Space>::left_to_return(const State& state) const {
  if (state.memory(kOpen) < 1) return 1;
  const Vector<Space> interrupted = origin(state, 0) - origin(state, 1);
  const double size = interrupted.norm();
  if (size == 0) return 1;
  return -(ratio(state) - origin(state, 0)).dot(interrupted) / (size * 2 * radius());
}

template <class Space>
double SanisandModuli<Space>::reversal(const State& state) const {
  if (state.memory(kTurning) == 0 && state.memory(kOpen) == 0) return 1;
  const Standing s = standing(state);
  return std::min({1 - gone_back(state, s), left_to_close(state, s), left_to_return(state)});
}

/// α was `at` the reversal: another loading begins there.
template <class Space>
void SanisandModuli<Space>::interrupt(State& state, const Vector<Space>& at) const {
  if (state.memory(kOpen) == kInterrupted) resume(state, 2);  // forgets the innermost loop
  double& open = state.memory(kOpen);
  for (int i = static_cast<int>(++open); i > 0; --i) origin(state, i) = origin(state, i - 1);
  origin(state, 0) = at;
  state.memory(kTurning) = 0;
}

/// The last `loadings` are over: the one before them goes on.
template <class Space>
void SanisandModuli<Space>::resume(State& state, int loadings) {
  for (int i = 0; i <= kInterrupted; ++i)
    if (i + loadings <= kInterrupted)
      origin(state, i) = origin(state, i + loadings);
    else
      origin(state, i).setZero();
  state.memory(kOpen) -= loadings;
}

template <class Space>
bool SanisandModuli<Space>::turn(State& state, const PointRate<Space>& rate) const {
  Standing s = standing(state);
  double& turning = state.memory(kTurning);
  auto turned = state.memory.template segment<kSize>(kSize);
  const double back = gone_back(state, s);
  bool changed = back >= 1;
  if (changed)
    interrupt(state, turned - radius() * s.n);
  else if (back <= 0)
    turning = 0;
  for (;; changed = true) {
    if (changed) s = standing(state);
    if (left_to_close(state, s) <= 0) {
      resume(state, 2);
    } else if (left_to_return(state) <= 0) {
      // Within the elastic range of where it turned.
      const Vector<Space> reversal = origin(state, 0);
      resume(state, 1);
      turned = reversal + radius() * standing(state).n;
      turning = 1;
    } else {
      break;
    }
  }
  // ∂f/∂σ : dσ
  const double rise = s.n.dot(rate.stress) - s.n.dot(s.ratio) * trace<Space>(rate.stress) / 3;
  if (turning == 0 && rise < -1e-9 * rate.stress.norm()) {
    turning = 1;
    turned = ratio(state);
  }
  return changed;
}

template class SanisandModuli<Axisymmetric>;
template class SanisandModuli<Tensor>;

}  // namespace triax::sim
