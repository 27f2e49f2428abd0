// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/probed_moduli.hpp"

#include "sim/control/control_solver.hpp"
#include "sim/law/on_yield.hpp"

namespace triax::sim {
namespace {

/// A compliance of the three axes in the components of the space (the response to dσ₂ = dσ₃ is the
/// sum of the responses to each).
template <class Space>
Matrix<Space> reduced(const Matrix<Tensor>& n) {
  if constexpr (Space::kSize == 6) {
    return n;
  } else {
    constexpr double root = std::numbers::sqrt2;
    Matrix<Space> q;
    q << n(0, 0), (n(0, 1) + n(0, 2)) / root, (n(1, 0) + n(2, 0)) / root,
        (n(1, 1) + n(1, 2) + n(2, 1) + n(2, 2)) / 2;
    return q;
  }
}

}  // namespace

template <class Space>
bool ProbedModuli<Space>::probe(const State& state, Matrix<Tensor>& plus,
                                Matrix<Tensor>& minus) const {
  PointState<Tensor> at{as_tensor(state.stress), state.void_ratio, state.memory};
  Response<Tensor> response;
  base_->response(at, response);
  const auto* form = std::get_if<StiffnessForm<Tensor>>(&response);
  const int mechanisms = form == nullptr ? 0 : form->mechanisms;
  base_->settle(at, (1U << mechanisms) - 1);
  at.stress = as_tensor(state.stress);
  base_->response(at, response);
  const unsigned standing = mechanisms_on_yield(*base_, at, mechanisms);
  plus.setZero();
  for (int j = 0; j < Tensor::kSize; ++j)
    for (const double sign : {1.0, -1.0}) {
      if (j >= 3 && sign < 0) continue;  // no interpolation of shear: both have the same column
      const PreparedControl<Tensor> control(
          MixedControl<Tensor>::stresses(sign * Vector<Tensor>::Unit(j)), 1);
      const auto rate = solve_control<Tensor>(response, control, {standing, std::nullopt},
                                              Vector<Tensor>::Zero());
      if (!rate.controllable) return false;
      (sign > 0 ? plus : minus).col(j) = sign * rate.strain;
      if (j >= 3) minus.col(j) = plus.col(j);
    }
  return true;
}

template <class Space>
void ProbedModuli<Space>::moduli(const State& state, Matrix<Space>& plus,
                                 Matrix<Space>& minus) const {
  Matrix<Tensor> p, m;
  if (!probe(state, p, m)) {
    plus.setConstant(std::nan(""));
    minus = plus;
    return;
  }
  plus = reduced<Space>(p);
  minus = reduced<Space>(m);
}

template <class Space>
PointState<Space> ProbedModuli<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  return {stress, void_ratio, base_->start(as_tensor(stress), void_ratio).memory};
}

template <class Space>
std::optional<std::string> ProbedModuli<Space>::objection(const State& state) const {
  const PointState<Tensor> at{as_tensor(state.stress), state.void_ratio, state.memory};
  if (auto base = base_->objection(at)) return base;
  Matrix<Tensor> plus, minus;
  if (probe(state, plus, minus)) return std::nullopt;
  return "a generalised triaxial path has no response here: the base law is at its limit";
}

template <class Space>
bool ProbedModuli<Space>::at_limit(const State& state) const {
  Matrix<Tensor> plus, minus;
  return state.p() > 0 && !probe(state, plus, minus);
}

template <class Space>
std::optional<std::string> ProbedModuli<Space>::warning(const State& state) const {
  return base_->warning({as_tensor(state.stress), state.void_ratio, state.memory});
}

template class ProbedModuli<Axisymmetric>;
template class ProbedModuli<Tensor>;

}  // namespace triax::sim
