// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/generalised_triaxial.hpp"
#include "sim/materials/sanisand.hpp"

namespace triax::sim {

/// Generalised triaxial moduli of SANISAND in closed form: a path that goes on from the last
/// reversal is elastoplastic, one that goes back is elastic. With C_e the elastic compliance, n_f
/// the yield normal, K_p the plastic modulus and R the flow direction (sanisand.hpp),
///
///   column j = C_e e_j + (n_f·e_j/K_p) R   where ±n_f·e_j > 0,   else C_e e_j
///
/// There is no elastic range: the yield surface always passes through the stress, on the side away
/// from the last reversal,
///
///   n = (r − α_in)/|r − α_in|,   α = r − √(2/3) m n,   (α − α_in):n = |r − α_in| − √(2/3) m
///
/// (nearer to α_in than 1.001 √(2/3) m it is taken as there). Loaded from the isotropic state
/// (α_in = 0) n is along r; unloaded from r, it points back through r = 0, which is a state like
/// any other: nothing happens to the moduli where q changes its sign. Fabric is left out.
///
/// Memory: α_in, α at the last reversal of dη, and those of the loadings that were interrupted,
/// while their loops are open. What goes back by less than the base law's elastic range, 2 m in η,
/// is no reversal (the turning point is remembered until it is passed again): to the base law that
/// is elastic, and a real servo's noise of some Pa would make the specimen stiff anew again and
/// again. A loop that goes back by more closes where α comes as far from its α_in as the reversal
/// before lies, or r comes back through α_in: the loop is then forgotten and the loading that it
/// interrupted goes on with its own α_in, as if there had been no loop (Masing's rule for loops
/// that close, Pyke 1979, J. Geotech. Eng. Div. ASCE 105:715). Of a loop in a loop in a loop the
/// inner ones are forgotten at once.
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
  double reversal(const State& state) const override;
  bool turn(State& state, const PointRate<Space>& rate) const override;
  std::optional<double> limit_stress_ratio() const override { return law_.limit_stress_ratio(); }

 private:
  static constexpr int kSize = Space::kSize;
  // Of the memory: α_in, r at the turning point, α_in of the loadings interrupted (the last one
  // first) and their number, whether turning.
  static constexpr int kInterrupted = 3;
  static constexpr int kOpen = (2 + kInterrupted) * kSize, kTurning = kOpen + 1;
  template <class AnyState>
  static auto origin(AnyState& s, int i) {
    return s.memory.template segment<kSize>(i == 0 ? 0 : (1 + i) * kSize);
  }
  /// On a yield surface that passes through the stress.
  struct Standing : Sanisand<Space>::Standing {
    double distance = 0;  ///< (α − α_in):n > 0
  };
  Standing standing(const State& state) const;
  double gone_back(const State& state, const Standing& s) const;
  double left_to_close(const State& state, const Standing& s) const;
  double left_to_return(const State& state) const;
  void interrupt(State& state, const Vector<Space>& at) const;
  static void resume(State& state, int loadings);
  Vector<Space> ratio(const State& state) const {
    return deviator<Space>(state.stress) / state.p();
  }
  double radius() const { return kSanisandRoot * law_.parameters().yield_radius; }

  Sanisand<Space> law_;
};

extern template class SanisandModuli<Axisymmetric>;
extern template class SanisandModuli<Tensor>;

}  // namespace triax::sim
