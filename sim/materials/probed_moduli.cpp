#include "sim/materials/probed_moduli.hpp"

#include "sim/point/control_solver.hpp"

namespace triax::sim {
namespace {

template <class Space>
Vector<Tensor> lifted(const Vector<Space>& a) {
  if constexpr (Space::kSize == 2)
    return as_tensor(a);
  else
    return a;
}

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

unsigned every_mechanism(const Response<Tensor>& response) {
  const auto* form = std::get_if<StiffnessForm<Tensor>>(&response);
  return form == nullptr ? 0 : (1U << form->mechanisms) - 1;
}

}  // namespace

template <class Space>
bool ProbedModuli<Space>::probe(const State& state, Matrix<Tensor>& plus,
                                Matrix<Tensor>& minus) const {
  PointState<Tensor> at{lifted<Space>(state.stress), state.void_ratio, state.memory};
  Response<Tensor> response;
  base_->response(at, response);
  const unsigned standing = every_mechanism(response);
  base_->settle(at, standing);
  base_->response(at, response);
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
  return {stress, void_ratio, base_->start(lifted<Space>(stress), void_ratio).memory};
}

template <class Space>
std::optional<std::string> ProbedModuli<Space>::objection(const State& state) const {
  const PointState<Tensor> at{lifted<Space>(state.stress), state.void_ratio, state.memory};
  if (auto base = base_->objection(at)) return base;
  Matrix<Tensor> plus, minus;
  if (probe(state, plus, minus)) return std::nullopt;
  return "a generalised triaxial path has no response here: the base law is at its limit";
}

template <class Space>
std::optional<std::string> ProbedModuli<Space>::warning(const State& state) const {
  return base_->warning({lifted<Space>(state.stress), state.void_ratio, state.memory});
}

template <class Space>
void ProbedModuli<Space>::memory_rate(const State& state, const Response<Space>&,
                                      const PointRate<Space>& rate, Memory& out) const {
  PointState<Tensor> at{lifted<Space>(state.stress), state.void_ratio, state.memory};
  Response<Tensor> response;
  base_->response(at, response);
  const unsigned standing = every_mechanism(response);
  base_->settle(at, standing);
  base_->response(at, response);
  const PreparedControl<Tensor> control(MixedControl<Tensor>::strains(lifted<Space>(rate.strain)),
                                        1);
  const auto driven =
      solve_control<Tensor>(response, control, {standing, std::nullopt}, Vector<Tensor>::Zero());
  base_->memory_rate(at, response, driven, out);
}

template class ProbedModuli<Axisymmetric>;
template class ProbedModuli<Tensor>;

}  // namespace triax::sim
