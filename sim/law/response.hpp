// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <variant>

#include "sim/mechanics/space.hpp"

namespace triax::sim {

/// What a law remembers beyond stress and void ratio; its entries are the law's own. Held in place,
/// so that a step allocates nothing.
inline constexpr int kMostMemory = 256;
using Memory = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostMemory, 1>;

/// Most mechanisms a law may have at once (the planes that meet in a corner, a cone and a cap).
inline constexpr int kMostMechanisms = 3;

/// Incremental response in stiffness form,
///
///   dσ = C dε − Σ λ_k c_k − N |dε|,   λ_k ≥ 0,   m_k·dε ≤ Σ_j H_kj λ_j,   equality where λ_k > 0
///
/// Elasticity has neither mechanisms nor N; a plastic mechanism has c = C r, m = C n and
/// H = h + n·C r (flow rule r, yield normal n, plastic modulus h); hypoplasticity has N; the
/// intergranular strain a mechanism of its own. A common positive factor of c, m and H only changes
/// the measure of λ: that is how a law says "infinitely stiff just after a reversal" (c = 0, H > 0)
/// without an infinite number. Memory that hardens with the mechanisms follows Σ λ_k slope_k.
template <class Space>
struct StiffnessForm {
  Matrix<Space> stiffness;                                            ///< C, Pa
  bool nonlinear = false;                                             ///< whether N is there
  Vector<Space> norm_term;                                            ///< N, Pa; only if nonlinear
  int mechanisms = 0;                                                 ///< their number; not with N
  std::array<Vector<Space>, kMostMechanisms> relaxation;              ///< c_k
  std::array<Vector<Space>, kMostMechanisms> trigger;                 ///< m_k
  Eigen::Matrix<double, kMostMechanisms, kMostMechanisms> hardening;  ///< H_kj
  std::array<Memory, kMostMechanisms> memory_slope;  ///< empty: the memory does not change with λ_k

  /// Makes room for a law that says all of it anew.
  void clear() {
    nonlinear = false;
    mechanisms = 0;
    for (Memory& slope : memory_slope) slope.resize(0);
  }

  /// Adds a plastic mechanism: dε^p = λ r, n·dσ ≤ h λ.
  void add_plastic(const Vector<Space>& flow, const Vector<Space>& normal, double modulus) {
    add_plastic(stiffness * flow, stiffness * normal, normal, modulus);
  }
  /// The same where C r and C n are known already.
  void add_plastic(const Vector<Space>& c_flow, const Vector<Space>& c_normal,
                   const Vector<Space>& normal, double modulus) {
    const auto k = static_cast<std::size_t>(mechanisms);
    relaxation[k] = c_flow;
    trigger[k] = c_normal;
    normals_[k] = normal;
    for (int j = 0; j < mechanisms; ++j) {
      const auto u = static_cast<std::size_t>(j);
      hardening(mechanisms, j) = normal.dot(relaxation[u]);
      hardening(j, mechanisms) = normals_[u].dot(c_flow);
    }
    hardening(mechanisms, mechanisms) = normal.dot(c_flow) + modulus;
    ++mechanisms;
  }

  /// Adds a mechanism given in strain: dσ −= λ c with λ = ⟨m·dε⟩.
  void add_switch(const Vector<Space>& c, const Vector<Space>& m) {
    relaxation[static_cast<std::size_t>(mechanisms)] = c;
    trigger[static_cast<std::size_t>(mechanisms)] = m;
    hardening(mechanisms, mechanisms) = 1;
    ++mechanisms;
  }

 private:
  std::array<Vector<Space>, kMostMechanisms> normals_;
};

/// Incremental response as an interpolation between compliances for loading and unloading along
/// the axes, Eqs. (26) and (27) of the paper:
///
///   INL2         dε = ½ (N⁺ + N⁻) dσ + ½ (N⁺ − N⁻) (dσ_j²)/|dσ|
///   octolinear   dε = ½ (N⁺ + N⁻) dσ + ½ (N⁺ − N⁻) (|dσ_j|)
///
/// in 1/Pa, principal axes fixed. In axisymmetry |dσ| counts dσ₃ twice.
template <class Space>
struct InterpolatedForm {
  Matrix<Space> plus, minus;
  bool quadratic = true;  ///< INL2; false: octolinear
};

template <class Space>
using Response = std::variant<StiffnessForm<Space>, InterpolatedForm<Space>>;

/// The response as a cleared stiffness form, reusing what is there.
template <class Space>
StiffnessForm<Space>& stiffness_form(Response<Space>& response) {
  auto* form = std::get_if<StiffnessForm<Space>>(&response);
  if (form == nullptr) form = &response.template emplace<StiffnessForm<Space>>();
  form->clear();
  return *form;
}
template <class Space>
InterpolatedForm<Space>& interpolated_form(Response<Space>& response) {
  auto* form = std::get_if<InterpolatedForm<Space>>(&response);
  return form != nullptr ? *form : response.template emplace<InterpolatedForm<Space>>();
}

/// Isotropic elasticity, K δδᵗ + 2G (I − δδᵗ/3).
template <class Space>
Matrix<Space> isotropic_stiffness(double bulk_pa, double shear_pa) {
  Matrix<Space> c;
  const double coupling = bulk_pa - 2 * shear_pa / 3;
  if constexpr (Space::kSize == 2) {
    c << coupling + 2 * shear_pa, std::numbers::sqrt2 * coupling, std::numbers::sqrt2 * coupling,
        2 * coupling + 2 * shear_pa;
  } else {
    c.setZero();
    c.template topLeftCorner<3, 3>().setConstant(coupling);
    c.diagonal().array() += 2 * shear_pa;
  }
  return c;
}

/// That stiffness times a tensor.
template <class Space>
Vector<Space> isotropic_product(double bulk_pa, double shear_pa, const Vector<Space>& a) {
  return 2 * shear_pa * a + ((bulk_pa - 2 * shear_pa / 3) * trace<Space>(a)) * identity<Space>();
}

}  // namespace triax::sim
