// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/generalised_triaxial.hpp"
#include "sim/materials/sanisand.hpp"

namespace triax::sim {

/// Generalised triaxial moduli of SANISAND in closed form: a path that raises the stress ratio is
/// elastoplastic, one that lowers it an elastic reversal. With C_e the elastic compliance, n_f the
/// yield normal, K_p the plastic modulus and R the flow direction (sanisand.hpp),
///
///   column j = C_e e_j + (n_f·e_j/K_p) R   where ±n_f·e_j > 0,   else C_e e_j
///
/// There is no elastic range: the yield surface always passes through the stress, α = r − √(2/3) m
/// n with n along r, and below a stress ratio of 1.001 m it is taken as there. Fabric is left out.
///
/// Memory: α_in, α at the last reversal of dη, and the sign of dη since. What goes back by less
/// than the base law's elastic range, 2 m in η, is no reversal (the turning point is remembered
/// until it is passed again): to the base law that is elastic, and a real servo's noise of some Pa
/// would make the specimen stiff anew again and again.
template <class Space>
class SanisandModuli : public GeneralisedTriaxial<Space> {
 public:
  using State = PointState<Space>;

  explicit SanisandModuli(const SanisandParameters& parameters);

  void moduli(const State& state, Matrix<Space>& plus, Matrix<Space>& minus) const override;
  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override;
  std::optional<std::string> objection(const State& state) const override;
  bool at_limit(const State& state) const override;
  std::optional<std::string> warning(const State& state) const override {
    return law_.warning(state);
  }
  double reversal(const State& state) const override { return 1 - gone_back(state); }
  bool turn(State& state, const PointRate<Space>& rate) const override;
  std::optional<double> limit_stress_ratio() const override { return law_.limit_stress_ratio(); }

 private:
  static constexpr int kSize = Space::kSize;
  // Of the memory, behind α_in and α at the turning point.
  static constexpr int kRising = 2 * kSize, kTurning = kRising + 1;
  /// On a yield surface that passes through the stress.
  typename Sanisand<Space>::Standing standing(const State& state) const;
  double gone_back(const State& state) const;

  Sanisand<Space> law_;
};

extern template class SanisandModuli<Axisymmetric>;
extern template class SanisandModuli<Tensor>;

}  // namespace triax::sim
