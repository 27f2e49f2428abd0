// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/law/parameters.hpp"
#include "sim/materials/generalised_triaxial.hpp"

namespace triax::sim {

/// Lists that a table of moduli needs: stress ratios and, for each, E₁, E₃, V₁³, V₃¹, V₃³ in
/// loading
/// (+) and unloading (−), as drained tests at constant σ₃ and at constant σ₁ give them.
std::vector<ParameterDescription> moduli_table_parameters();

/// Generalised triaxial moduli from a user's table, axisymmetric. Linear between the stress ratios
/// η = q/p′ of the table; E grows as (p′/p_ref)^n. A state outside the table is refused.
class ModuliTable : public GeneralisedTriaxial<Axisymmetric> {
 public:
  /// Throws std::invalid_argument (list, what is wrong with it).
  explicit ModuliTable(const ParameterSet& set);

  void moduli(const State& state, Matrix<Axisymmetric>& plus,
              Matrix<Axisymmetric>& minus) const override;
  std::optional<std::string> objection(const State& state) const override;

 private:
  struct Side {  // of N⁺ or N⁻
    std::vector<double> e1_pa, e3_pa, v13, v31, v33;
  };
  Matrix<Axisymmetric> compliance(const Side& side, double eta, double factor) const;

  double reference_pa_ = 0, exponent_ = 0;
  std::vector<double> eta_;
  Side plus_, minus_;
};

}  // namespace triax::sim
