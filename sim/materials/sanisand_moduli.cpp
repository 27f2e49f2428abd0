// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/sanisand_moduli.hpp"

#include <algorithm>
#include <cmath>

#include "sim/materials/component_names.hpp"

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
  return {stress, void_ratio, Memory::Zero(kFalling + Space::kSize)};
}

template <class Space>
std::vector<std::string> SanisandModuli<Space>::memory_names() const {
  std::vector<std::string> names = {"eta_left_1", "eta_back_1", "eta_left_2", "eta_back_2"};
  name_components<Space>("ratio_falling", names);
  return names;
}

template <class Space>
typename SanisandModuli<Space>::Standing SanisandModuli<Space>::standing(const State& state) const {
  const double radius = kSanisandRoot * law_.parameters().yield_radius;
  Standing s{.p = state.p(), .void_ratio = state.void_ratio};
  s.ratio = deviator<Space>(state.stress) / s.p;
  const double size = s.ratio.norm();
  s.n = size > 0 ? Vector<Space>(s.ratio / size) : compression<Space>();
  s.along = std::max(size - radius, 0.0);
  return s;
}

/// What one state is asked for. Where a step ends it is the objection, where the next one begins
/// the moduli and the memory.
template <class Space>
struct SanisandModuli<Space>::Kept {
  Kept(const SanisandModuli& moduli, const State& state)
      : law(moduli.mark_),
        stress(state.stress),
        void_ratio(state.void_ratio),
        standing(moduli.standing(state)),
        loading(moduli.law_.loading(standing)),
        eta(std::max(standing.ratio.norm() / kSanisandRoot,
                     moduli.law_.parameters().yield_radius)) {}
  bool answers(const Mark& asked, const State& state) const {
    return law == asked && stress == state.stress && void_ratio == state.void_ratio;
  }

  Mark law;
  Vector<Space> stress;
  double void_ratio;
  Standing standing;
  Loading loading;
  double eta;  ///< |η|, at least m
};

/// Valid until the next call on this thread.
template <class Space>
const typename SanisandModuli<Space>::Kept& SanisandModuli<Space>::at(const State& state) const {
  thread_local std::optional<Kept> kept;
  if (!kept || !kept->answers(mark_, state)) kept.emplace(*this, state);
  return *kept;
}

template <class Space>
std::optional<std::string> SanisandModuli<Space>::objection(const State& state) const {
  if (!(state.p() > 0)) return "p' is not above 0, where the law ends";
  if (auto base = law_.objection(state.stress, state.void_ratio)) return base;
  if (at_limit(state))
    return "the stress ratio is on the bounding surface of the base law, where its "
           "generalised-triaxial moduli do not exist";
  return std::nullopt;
}

template <class Space>
bool SanisandModuli<Space>::at_limit(const State& state) const {
  if (!(state.p() > 0)) return false;
  const Kept& here = at(state);
  return !(here.loading.bounding > here.standing.along);
}

template <class Space>
void SanisandModuli<Space>::moduli(const State& state, Matrix<Space>& plus,
                                   Matrix<Space>& minus) const {
  const Kept& here = at(state);
  const Standing& s = here.standing;
  const Loading& l = here.loading;
  const double eta = here.eta;
  // In first loading to the bit what it is without a memory.
  const double from_last =
      eta < state.memory(0) ? kSanisandRoot * distance(state.memory, eta) : s.along;
  const double modulus = 2.0 / 3 * s.p * l.stiffness * (l.bounding - s.along);  // K_p · distance
  // The compliance of isotropic elasticity has the form of its stiffness.
  plus = isotropic_stiffness<Space>(1 / (9 * (law_.bulk_ratio() * l.shear)), 1 / (4 * l.shear));
  minus = plus;
  const Vector<Space> flow = (from_last / modulus) * l.direction;
  for (int j = 0; j < kPrincipalAxes<Space>; ++j) {
    Matrix<Space>& loaded = l.normal(j) > 0 ? plus : minus;
    loaded.col(j) += l.normal(j) * flow;
  }
}

/// (α − α_in):n √(3/2)
template <class Space>
double SanisandModuli<Space>::distance(const Memory& loops, double eta) const {
  double outer = law_.parameters().yield_radius, share = 1, distance = eta - outer;
  for (int k = 0; k < kLoops && eta < loops(2 * k); ++k) {
    const double left = loops(2 * k), back = std::min(eta, loops(2 * k + 1));
    const double x = std::min((left - eta) / range(), 1.0), w = 1 - x * x * (3 - 2 * x);
    const double size = (left - back) / (left - outer);
    share *= size * size * size;
    distance = w * distance + (1 - w) * share * (eta - back);
    outer = back;
  }
  return distance;
}

template <class Space>
double SanisandModuli<Space>::reversal(const State& state) const {
  const auto begin = state.memory.template tail<Space::kSize>();
  const double size = begin.norm();
  if (size == 0) return 1;
  const Vector<Space> ratio = deviator<Space>(state.stress) / state.p();
  return (begin - ratio).dot(ratio) / size;
}

template <class Space>
bool SanisandModuli<Space>::turn(State& state, const PointRate<Space>& rate) const {
  const Kept& here = at(state);
  const Standing& s = here.standing;
  const double eta = here.eta;
  Memory& loops = state.memory;
  int open = 0;
  bool coming_up = true;
  for (; open < kLoops && eta < loops(2 * open); ++open) {
    double& back = loops(2 * open + 1);
    coming_up = eta > back && loops(2 * open) - back >= range();
    if (eta > back) continue;
    back = eta;
    ++open;
    break;
  }
  // Those passed, and those within a loop that goes further back.
  loops.segment(2 * open, 2 * (kLoops - open)).setZero();
  // ∂f/∂σ : dσ
  const double rise = s.n.dot(rate.stress) - s.n.dot(s.ratio) * trace<Space>(rate.stress) / 3;
  const bool falls = rise < -1e-9 * rate.stress.norm();
  if (falls && coming_up && open < kLoops) loops.template segment<2>(2 * open).setConstant(eta);
  if (falls)
    loops.template tail<Space::kSize>() = s.ratio;
  else
    loops.template tail<Space::kSize>().setZero();
  return false;
}

template class SanisandModuli<Axisymmetric>;
template class SanisandModuli<Tensor>;

}  // namespace triax::sim
