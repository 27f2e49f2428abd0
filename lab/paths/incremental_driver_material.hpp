// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lab/paths/incremental_driver_reader.hpp"
#include "lab/paths/inp_lines.hpp"

namespace triax::lab {

/// What parameters.inp and initialconditions.inp hold, as they have it.
struct InpMaterial {
  std::string name;  ///< first line, to the #
  std::vector<double> properties;
  sim::Vector<sim::Tensor> stress = sim::Vector<sim::Tensor>::Zero();  ///< ours: Pa, compression
  std::vector<double> state;                                           ///< STATEV
};

/// Throws BadInput.
InpMaterial read_inp_material(InpLines& parameters, InpLines& start);

/// The same as a law of triax with its start.
struct InpStart {
  MaterialSet material;
  double void_ratio = 0;
  std::vector<double> memory;  ///< empty: as the law starts
};

/// By name: a law of triax with its numbers in the order of its table; MCC (λ, κ, M, ν; STATEV 1 is
/// the void ratio, 8 the preconsolidation pressure); hypoplasticity with 16 numbers, either φ_c in
/// degrees, p_t, h_s, n, e_d0, e_c0, e_i0, α, β, m_R, m_T, R, β_r, χ, K_w, e (STATEV 1 to 6 the
/// intergranular strain, 7 the void ratio) or, named Hypo-VW96..., φ_c in rad, ν, h_s, n, e_d0,
/// e_c0, e_i0, α, β, m_T, m_R, R, β_r, χ (STATEV 1 the void ratio). With a library in the settings:
/// that, with everything as it stands. `where` is what messages call parameters.inp. Throws
/// BadInput.
InpStart start_from_inp(const InpMaterial& inp, const IncrementalDriverSettings& settings,
                        const std::string& where, const std::string& folder,
                        std::vector<std::string>& warnings);

}  // namespace triax::lab
