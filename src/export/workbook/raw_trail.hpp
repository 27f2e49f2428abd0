// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// lab/reduction/raw_reduction as formulas: the same operations in the same order.
#include <optional>
#include <string>
#include <vector>

#include "src/export/workbook/reading_terms.hpp"
#include "src/export/workbook/specimen_sheet.hpp"

namespace triax::src {

/// Dimensions from which strains count, as a row of the stages' sheet.
struct ReferenceRow {
  std::int64_t from_reading = 0;
  int stage = 1;
  Term height_m, volume_m3, displacement_m, back_volume_m3, void_ratio, membrane_pa;
  std::string how;  ///< where the height comes from
};

class RawTrail {
 public:
  /// References stand from `first_reference_row` of the stages' sheet on, states have so many
  /// columns before their own (StateCell).
  RawTrail(const lab::RecordHeader& header, std::string membrane, SpecimenTerms specimen,
           std::size_t first_reference_row, std::size_t state_columns, ReadingTerms readings);

  ReducedTerms reduce(const lab::Reading& reading, StateTerms& keep);
  const std::vector<ReferenceRow>& references() const { return references_; }

 private:
  /// Cells of a row of references.
  struct Reference {
    Term height_m, volume_m3, area_m2, displacement_m, back_volume_m3, void_ratio, membrane_pa;
  };
  void start_stage(const lab::Reading& reading);
  ReferenceRow start_of_shear() const;
  ReferenceRow start_of_stage() const;
  Term void_ratio_at(const Term& volume) const;
  Term membrane_stiffness(const Term& area) const;
  void correct_for_membrane(ReducedTerms& s, StateTerms& keep) const;

  lab::RecordHeader header_;
  std::string membrane_;
  SpecimenTerms specimen_;
  std::size_t first_row_, state_columns_;
  ReadingTerms readings_;
  std::vector<ReferenceRow> references_;
  Reference from_;
  std::optional<int> stage_;
  lab::StageRole role_ = lab::StageRole::unknown;
  bool sheared_ = false;
  Term last_displacement_, last_back_volume_;
  Term height_now_, volume_now_;  ///< before shear: after what was consolidated
  Term shortening_, outflow_;     ///< of consolidation so far
  bool consolidated_ = false;
};

}  // namespace triax::src
