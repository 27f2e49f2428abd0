// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The frames in which incrementalDriver takes components: six linear combinations of stress and
// the six of strain that are conjugate to them, written for tension positive and γ = 2 ε.
//
//   *Cartesian        σ₁₁, σ₂₂, σ₃₃, σ₁₂, σ₁₃, σ₂₃
//   *Roscoe           p, q = −(σ₁ − (σ₂ + σ₃)/2), z = σ₃ − σ₂, shear as above
//   *RoscoeIsomorph   P = √3 p, Q = √(2/3) q, Z = z/√2
//   *Rendulic         −σ₁, −(σ₂ + σ₃)/√2, (σ₃ − σ₂)/√2
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "sim/control/mixed_control.hpp"

namespace triax::lab {

struct InpFrame {
  sim::Matrix<sim::Tensor> stress;  ///< rows: components of stress, in kPa per Pa (ours)
  sim::Matrix<sim::Tensor> strain;  ///< rows: of strain
  std::array<std::string, 6> stress_labels, strain_labels;
};

/// By keyword, with its star, in any case; nothing where there is none of that name.
std::optional<InpFrame> find_inp_frame(std::string_view keyword);

/// The coefficients of our components (Pa, compression positive) in σ_k and ε_k of the files.
Eigen::Matrix<double, 1, 6> inp_stress_row(int component);
Eigen::Matrix<double, 1, 6> inp_strain_row(int component);

}  // namespace triax::lab
