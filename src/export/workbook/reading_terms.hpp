// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Readings as formulas see them, and the state that a formula gives beside each.
#include <cstddef>
#include <utility>
#include <vector>

#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"
#include "src/export/workbook/layout.hpp"

namespace triax::src {

/// Cells of the sheet of readings in SI.
class ReadingTerms {
 public:
  /// A reading stands so many rows below its state.
  ReadingTerms(lab::RecordHeader header, std::size_t rows_below)
      : header_(std::move(header)), below_(rows_below) {}

  /// Of the reading whose state stands in `row`; unknown where it does not hold it.
  Term of(lab::Quantity quantity, const lab::Reading& reading, std::size_t row) const;

 private:
  lab::RecordHeader header_;
  std::size_t below_;
};

/// The states' cells of one row, in no order: column and what gives it. A cell of the row that was
/// kept stands for its formula in those behind it.
class StateTerms {
 public:
  StateTerms(std::size_t columns_before, std::size_t row) : before_(columns_before), row_(row) {}

  Term keep(StateCell place, const Term& term) {
    return keep_in(before_ + static_cast<std::size_t>(place), term);
  }
  /// In a column of study::columns_handed_over(). What has no formula stands as a number.
  Term keep_in(std::size_t column, const Term& term) {
    cells_.emplace_back(column, term);
    return cell(address(column, row_ + 1), term.value);
  }
  std::size_t row() const { return row_; }
  const std::vector<std::pair<std::size_t, Term>>& cells() const { return cells_; }

 private:
  std::size_t before_, row_;
  std::vector<std::pair<std::size_t, Term>> cells_;
};

/// What a reduction gives of a reading, as cells that are kept.
struct ReducedTerms {
  Term axial_strain, volumetric_strain, void_ratio, area_m2;
  Term pore_pressure_pa, axial_pa, radial_pa, q_pa, p_eff_pa;
};

/// Places of study::columns_handed_over() that formulas refer to.
inline constexpr std::size_t kAxialStrainColumn = 3, kVolumetricStrainColumn = 4;

}  // namespace triax::src
