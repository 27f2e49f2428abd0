// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// lab/reduction/reduced_columns as formulas: a record that holds stresses and strains is completed
// by the same operations in the same order.
#include "src/export/workbook/reading_terms.hpp"
#include "src/export/workbook/specimen_sheet.hpp"

namespace triax::src {

class ReducedTrail {
 public:
  ReducedTrail(const lab::RecordHeader& header, const SpecimenTerms& specimen,
               ReadingTerms readings);
  ReducedTerms reduce(const lab::Reading& reading, StateTerms& keep);

 private:
  bool undrained(int stage) const;
  void take_stresses(const lab::Reading& reading, StateTerms& keep, ReducedTerms& s) const;
  void take_strains(const lab::Reading& reading, StateTerms& keep, ReducedTerms& s);

  lab::RecordHeader header_;
  ReadingTerms readings_;
  Term void_ratio_start_, first_void_ratio_;
  bool only_excess_ = false;
};

}  // namespace triax::src
