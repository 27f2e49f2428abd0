// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "lab/records/cells/printed_value.hpp"
#include "lab/records/findings.hpp"
#include "lab/records/table_layout.hpp"

namespace triax::lab {

/// Compares columns of one row that say the same in two ways, row by row, in constant memory:
///   q = σ₁′ − σ₃′ = σ₁ − σ₃ = η p′      p′ = (σ₁′ + 2σ₃′)/3 = σ₃′ + q/3 = σ₁′ − 2q/3
///   σ₁′ = σ₁ − u      σ₃′ = σ₃ − u = σ_c − u      σ₃ = σ_c
///   ε_v = ε₁ + 2ε₃ = 1 − (1 − ε₀)(1 + e)/(1 + e₀)      ε_q = ε₁ − ε_v/3 = 2(ε₁ − ε₃)/3
///   Δu = u − u₀ + Δu₀
/// with the values of index 0 from the first row of the stage, or from a row where ε_v or Δu was
/// set to zero. Strains of the original and of the present dimensions, and logarithmic ones, pass.
/// Columns that agree to the digits that are printed never raise a finding.
class ColumnConsistency {
 public:
  explicit ColumnConsistency(const TableLayout& layout);

  /// True where a relation holds that column: its cells need their printed error.
  bool needs(Quantity quantity) const { return needed_[index(quantity)]; }
  bool is_needed() const { return !relations_.empty(); }
  /// Processes a row, SI; `stage` as in the file, missing where it has none. One finding for each
  /// relation that the row contradicts.
  void add(const std::array<PrintedValue, kQuantityCount>& row, double stage, std::int64_t line,
           Findings& findings);

 private:
  struct Relation;
  using Cells = std::array<PrintedValue, kQuantityCount>;
  static const std::vector<Relation>& all_relations();
  /// `scale` of single precision, see PrintedValue::contradicts.
  void compare(const Relation& relation, const Cells& row, double scale, std::int64_t line,
               Findings& findings);
  const PlannedColumn& column_of(Quantity quantity) const;

  const TableLayout& layout_;
  std::vector<const Relation*> relations_;  ///< those whose columns the table has
  std::array<bool, kQuantityCount> needed_{};
  std::vector<Quantity> stresses_;  ///< of those that are needed
  Cells start_{};                   ///< values of index 0
  double stage_ = kMissing;
};

}  // namespace triax::lab
