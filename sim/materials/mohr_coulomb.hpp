// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Mohr and Coulomb's surface, the exact hexagon; elastic within (sim/materials/elastic.hpp),
// perfectly plastic on it, flow not associated. For a pair of principal stresses σ_i ≥ σ_j:
//
//   f_ij = (σ_i − σ_j) − (σ_i + σ_j) sin φ − 2c cos φ
//   dε^p = λ_ij ((1 − sin ψ) v_i v_i − (1 + sin ψ) v_j v_j)
//
// Mechanisms. In axisymmetry compression and extension, each with both its planes:
// dε_v^p = −M_g dε_q^p, M_g = 6 sin ψ/(3 − sin ψ) in compression, 6 sin ψ/(3 + sin ψ) in extension.
// Of a tensor with σ₁ ≥ σ₂ ≥ σ₃ the planes (1,3), (1,2), (2,3). On an edge of the hexagon two of
// them would be at yield, σ₂ = σ₃ (triaxial compression) or σ₁ = σ₂ (extension), and so is every
// plane between: dε^p = Λ (1 − sin ψ) v₁v₁ᵗ − (1 + sin ψ) X with X ≥ 0 in the plane of the equal
// stresses, tr X = Λ. There the mechanisms are the planes (1,w), w at 0 and ±60° to the axis along
// which the increment extends most (of extension: (w,3), compresses most), which span the X that
// keep the edge; off the edge leads (1,w₀) alone, the (1,3) to be.
//
// p is p′ (Pa), compression positive. At the apex, p sin φ + c cos φ = 0, the direction of flow is
// not defined: states there and beyond are refused.
//
// Memory: none in axisymmetry. Of a tensor where it stands: 0 within the surface, 1 on a plane, 2
// on an edge of compression, 3 on one of extension; and on the surface the frame v₁v₁ᵗ − v₃v₃ᵗ,
// which names the planes from one instant to the next and, on an edge, holds the axes of the
// increment.
#include "sim/law/mark.hpp"
#include "sim/materials/elastic.hpp"

namespace triax::sim {

struct MohrCoulombParameters : ElasticParameters {
  double friction_angle = 0;  ///< φ, rad
  double cohesion_pa = 0;     ///< c
  double dilation_angle = 0;  ///< ψ, rad
};

const ParameterTable<MohrCoulombParameters>& mohr_coulomb_table();
LawDescription mohr_coulomb_law();

template <class Space>
class MohrCoulomb : public Law<Space> {
 public:
  using State = PointState<Space>;
  using Rate = PointRate<Space>;

  /// Throws std::invalid_argument (parameter, value found, what would be right).
  explicit MohrCoulomb(const MohrCoulombParameters& parameters);

  const MohrCoulombParameters& parameters() const { return parameters_; }

  State start(const Vector<Space>& stress, double void_ratio) const override;
  std::vector<std::string> memory_names() const override;
  bool carries_tension() const override {
    return parameters_.cohesion_pa > 0 && parameters_.pressure_exponent == 0;
  }
  std::optional<std::string> objection(const State& state) const override;
  std::optional<std::string> warning(const State& state) const override;
  using Law<Space>::response;
  void response(const State& state, Response<Space>& out) const override;
  /// f over 2(p sin φ + c cos φ).
  double yield_distance(const State& state, int mechanism) const override;
  void settle(State& state, unsigned on_yield) const override;
  bool turn(State& state, const Rate& rate) const override;
  std::optional<double> limit_stress_ratio() const override;

 private:
  struct Planes;
  const Planes& planes(const PointState<Tensor>& state) const;
  void remember(PointState<Tensor>& state, const Eigen::Matrix3d& axes, double place) const;
  double strength(double p) const { return 2 * (p * sine_ + cohesion_); }
  double excess(double high, double low) const {
    return high - low - (high + low) * sine_ - 2 * cohesion_;
  }

  MohrCoulombParameters parameters_;
  double sine_, flow_sine_, cohesion_;  ///< sin φ, sin ψ, c cos φ (Pa)
  Mark mark_;
};

extern template class MohrCoulomb<Axisymmetric>;
extern template class MohrCoulomb<Tensor>;

}  // namespace triax::sim
