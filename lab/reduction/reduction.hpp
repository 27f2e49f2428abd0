// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From raw channels to stresses and strains, one reading at a time, in constant memory.
//
// Right cylinder (formats: ASTM D4767, D7181; ISO 17892-9), c = start of shear:
//   ε₁ = (δ − δ_c)/H_c        ε_v = −(V_b − V_b,c)/V_c     (water in = volume increase)
//   A  = A_c (1 − ε_v)/(1 − ε₁)      q = F/A      σ₁′ = σ_c + q − u,   σ₃′ = σ_c − u
//   e  = e_c − ε_v (1 + e_c)
// A record that holds only reduced stresses and strains enters here too: its columns are taken as
// they are and completed (p' and q from σ₁′, σ₃′ or the other way round).
#include <memory>
#include <string>
#include <vector>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// How the membrane's hoop and axial stiffness is taken off q (compression positive, dq_m ≥ 0).
enum class MembraneCorrection {
  none,
  astm,  ///< Δq = 4 E t ε₁/D_c (ASTM D4767)
  iso,   ///< Δσ₁ = (4Et/D₁)(ε₁ + ε_v/3), Δσ₃ = (4Et/D₁)(ε_v/3) (ISO 17892-9)
};

struct ReductionOptions {
  MembraneCorrection membrane = MembraneCorrection::none;
};

class Reduction {
 public:
  /// Throws BadInput if the specimen's dimensions are needed and missing (says which key to set).
  Reduction(const RecordHeader& header, const ReductionOptions& options);
  ~Reduction();
  Reduction(const Reduction&) = delete;
  Reduction& operator=(const Reduction&) = delete;

  /// kMostImpossible: readings in a row with a strain of 1 or more that no specimen can have given.
  /// Their states are unknown, as in a simulation: a sensor dropped out. Throws BadInput at the
  /// next one, with the line of the first: the units must be wrong.
  static constexpr std::int64_t kMostImpossible = 5;
  State reduce(const Reading& reading);

  /// "none", "astm" or "iso"; empty where whoever reduced the record chose it.
  std::string membrane_correction() const;
  /// Dimensions, void ratio, p'0 and B, as far as the readings so far tell.
  Consolidation consolidation() const;
  /// B value; closure of the columns that the file itself had computed. What the record's reader
  /// had to join (`record_warnings`) may explain a difference.
  std::vector<Check> checks(bool back_volume_joined) const;
  std::vector<Warning> warnings() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab
