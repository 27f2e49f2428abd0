// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The table of rules from which assess() makes the result.
#include <span>
#include <string_view>

#include "lab/collapse/assessment.hpp"

namespace triax::lab {

/// An assessment on its way through the table.
struct DraftAssessment {
  Collapse collapse;
  /// Strength was lost with the drainage open and under a prescribed displacement.
  bool drained = false;
  bool by_readings = false;  ///< from reading to reading (Backbone), where windows saw no onset
};

/// One row. A row that applies changes the draft that the rows above it left.
struct AssessmentRule {
  std::string_view name;       ///< "softening"
  std::string_view condition;  ///< in words, with the names of assessment_limits.hpp
  std::string_view result;     ///< in words: kind, instants, end of the assessment
  bool (*applies)(const Evidence&, const DraftAssessment&) = nullptr;
  void (*apply)(const Evidence&, DraftAssessment&) = nullptr;
  bool is_final = false;  ///< no row below is looked at
};

std::span<const AssessmentRule> assessment_rules();

/// Goes through the rows once, from top to bottom. assess() is this with assessment_rules().
Collapse assess_by(std::span<const AssessmentRule> rules, const Evidence& evidence,
                   std::vector<Criterion> criteria);

}  // namespace triax::lab
