// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Incrementally nonlinear laws of Darve: INL2 and octolinear, Eqs. (25) to (27) of the paper.
//
//   INL2         dε = ½ (N⁺ + N⁻) dσ + ½ (N⁺ − N⁻) (dσ_j²)/|dσ|
//   octolinear   dε = ½ (N⁺ + N⁻) dσ + ½ (N⁺ − N⁻) (|dσ_j|)
//
// Column j of N⁺ and N⁻ is the response to dσ_j = +1 and −1 alone, divided by ±1: the moduli
// E_j = dσ_j/dε_j and V_j^i = −dε_i/dε_j of a generalised triaxial path, in loading and in
// unloading. Principal axes are fixed: a stress with shear components is refused. No yield surface,
// no split of strains; homogeneous of degree one.
//
// Darve's own functions for these moduli are not public. They come from a base, and a result is
// labelled by it (Material::based_on): "INL2 with generalised-triaxial moduli from ...".
#include <memory>

#include "sim/law/parameters.hpp"
#include "sim/materials/generalised_triaxial.hpp"

namespace triax::sim {

LawDescription inl2_law();
LawDescription octolinear_law();

enum class Interpolation { inl2, octolinear };

template <class Space>
class Interpolated : public Law<Space> {
 public:
  using State = PointState<Space>;

  Interpolated(Interpolation kind, std::shared_ptr<const GeneralisedTriaxial<Space>> base)
      : kind_(kind), base_(std::move(base)) {}

  const GeneralisedTriaxial<Space>& base() const { return *base_; }

  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override;
  double memory_scale(int entry) const override { return base_->memory_scale(entry); }
  std::optional<std::string> objection(const State& state) const override;
  bool at_limit(const State& state) const override { return base_->at_limit(state); }
  std::optional<std::string> warning(const State& state) const override;
  using Law<Space>::response;
  void response(const State& state, Response<Space>& out) const override;
  double reversal(const State& state) const override { return base_->reversal(state); }
  bool turn(State& state, const PointRate<Space>& rate) const override {
    return base_->turn(state, rate);
  }
  std::optional<double> limit_stress_ratio() const override { return base_->limit_stress_ratio(); }

 private:
  Interpolation kind_;
  std::shared_ptr<const GeneralisedTriaxial<Space>> base_;
};

extern template class Interpolated<Axisymmetric>;
extern template class Interpolated<Tensor>;

}  // namespace triax::sim
