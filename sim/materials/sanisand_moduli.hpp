// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/law/mark.hpp"
#include "sim/materials/generalised_triaxial.hpp"
#include "sim/materials/sanisand.hpp"

namespace triax::sim {

/// Generalised triaxial moduli of SANISAND in closed form: a path that raises the stress ratio is
/// elastoplastic, one that lowers it an elastic reversal. With C_e the elastic compliance, n_f the
/// yield normal, K_p the plastic modulus and R the flow direction (sanisand.hpp),
///
///   column j = C_e e_j + (n_f·e_j/K_p) R   where ±n_f·e_j > 0,   else C_e e_j
///
/// The yield surface always passes through the stress, α = r − √(2/3) m n with n along r; below a
/// stress ratio of m α = 0. Fabric is left out.
///
/// K_p grows without bound where the distance d = (α − α_in):n vanishes. In first loading d = |η| −
/// m (times √(2/3); |η| = √(3/2) |r|). Where |η| has turned at `left` and come back as far as
/// `back`, loading again is stiff and meets the loading that it left:
///
///   d = w d of the loading that was left + (1 − w) s³ (|η| − back),
///   w = 1 − x² (3 − 2x),  x = (left − |η|)/0.2 m, at most 1,
///   s = (left − back)/(left − where that loading came from)
///
/// s = 1 is what the base law does after a reversal; what is small beside the loading that it
/// interrupts is nearly elastic. At `left` w = 1: there the old loading goes on as if it had never
/// been interrupted. Where |η| falls, back = |η|, and over a tenth of the base law's elastic range
/// 2m the answer becomes elastic. A loop within a loop is kept once, s³ being the product of both;
/// not so a loop in that one, or in one smaller than 0.2 m. Through q = 0 the answer is continuous:
/// d = 0 there, N⁺ = N⁻ = C_e, and loading to the other side is first loading.
///
/// At the same |η| d is never smaller on the way up than on the way down, and R is along r: a loop
/// of η at constant p′ gives no work.
///
/// Memory: `left` and `back` of the loop, then those of the loop within it, all as |η|, at
/// least m; 0 where there is none. Then r where the last step began if |η| fell there, else 0:
/// where |η| stops falling within a step, as at q = 0, is isolated by reversal(), (r_begin −
/// r):r/|r_begin|.
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
  static constexpr int kLoops = 2, kFalling = 2 * kLoops;
  using Standing = typename Sanisand<Space>::Standing;
  using Loading = typename Sanisand<Space>::Loading;
  /// On a yield surface that passes through the stress.
  Standing standing(const State& state) const;
  struct Kept;
  const Kept& at(const State& state) const;
  double distance(const Memory& loops, double eta) const;
  /// Fall of |η| over which the answer becomes elastic.
  double range() const { return 0.2 * law_.parameters().yield_radius; }

  Sanisand<Space> law_;
  Mark mark_;
};

extern template class SanisandModuli<Axisymmetric>;
extern template class SanisandModuli<Tensor>;

}  // namespace triax::sim
