// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Modified Cam-Clay (Roscoe and Burland 1968), with flow associated and elasticity from the slope
// of the swelling line:
//
//   f = q² + M² p (p − p_c),   dε^p = λ_p ∂f/∂σ:   dε_v^p/dε_q^p = (M² − η²)/(2η)
//   K = (1 + e) p/κ,   G = 3(1 − 2ν)/(2(1 + ν)) K
//   dp_c = p_c (1 + e)/(λ − κ) dε_v^p
//
// p is p′ (Pa), compression positive; q = √(3/2)|s|. M is the same at every Lode angle, in
// extension as in compression. The void ratio of the normal consolidation line is not a parameter:
// start() takes the given void ratio to lie on it where the overconsolidation ratio is 1. The law
// has no instability line below M: undrained, a normally consolidated state keeps q rising up to
// it.
//
// Within the surface K and G at p alone have no energy: a closed cycle of p and q there gains or
// loses work. `hyperelastic` chooses (sim/materials/hyperelastic.hpp, n = 1)
//
//   C = 2G (I − δδᵗ/3) + K σσᵗ/p²
//
// with the same K and G. As K grows with 1 + e, what vanishes over every closed cycle is the work
// per volume of solids, ∮ (1 + e) σ:dε.
//
// Memory: p_c (Pa).
#include "sim/materials/hyperelastic.hpp"

namespace triax::sim {

struct CamClayParameters {
  double compression_slope = 0;        ///< λ, of e against ln p
  double swelling_slope = 0;           ///< κ
  double critical_stress_ratio = 0;    ///< M
  double poisson_ratio = 0;            ///< ν
  double overconsolidation_ratio = 1;  ///< p_c of the start over that of its stress
  double hyperelastic = 0;             ///< 1: elasticity from an energy
};

const ParameterTable<CamClayParameters>& cam_clay_table();
LawDescription cam_clay_law();

template <class Space>
class CamClay : public Law<Space> {
 public:
  using State = PointState<Space>;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit CamClay(const CamClayParameters& parameters);

  const CamClayParameters& parameters() const { return parameters_; }

  /// With p_c such that the yield surface through the stress is OCR times smaller.
  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override { return {"p_c_Pa"}; }
  double memory_scale(int) const override;
  std::optional<std::string> objection(const State& state) const override;
  using Law<Space>::response;
  void response(const State& state, Response<Space>& out) const override;
  /// Size of the surface through the stress over p_c, less 1.
  double yield_distance(const State& state, int mechanism) const override;
  void settle(State& state, unsigned on_yield) const override;
  std::optional<double> limit_stress_ratio() const override;

  double bulk_modulus(const State& state) const;
  double preconsolidation(const State& state) const { return state.memory(0); }  ///< p_c, Pa

 private:
  double surface_through(const Vector<Space>& stress) const;

  CamClayParameters parameters_;
};

extern template class CamClay<Axisymmetric>;
extern template class CamClay<Tensor>;

}  // namespace triax::sim
