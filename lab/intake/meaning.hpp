// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Quantity, unit and sign of each column of a table: the assignment with
// the largest evidence, which is that of the names (lexicon.hpp) plus that of the readings
// (identities.hpp), each as a log-likelihood.
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/intake/column_readings.hpp"
#include "lab/intake/identities.hpp"

namespace triax::lab {

struct ColumnMeaning {
  ColumnReading reading;
  /// The best other meaning of this column, and by how much the evidence of the whole assignment
  /// is smaller with it. Nothing if no other was near.
  std::optional<ColumnReading> other;
  double lead = 0;
  double unit_lead = HUGE_VAL;  ///< the same over another unit of the same quantity
  /// Leads below this are no decision: a question.
  static constexpr double kDecided = 1.5;
  bool is_decided() const { return !other || lead >= kDecided; }
};

struct HeldIdentity {
  const Identity* identity = nullptr;
  double evidence = 0;
};

struct Meaning {
  std::vector<ColumnMeaning> columns;
  std::vector<HeldIdentity> identities;  ///< that the readings decided for or against
  const ColumnMeaning* of(std::string_view quantity) const;
};

/// Pre-condition: all columns have equally many values.
Meaning find_meaning(std::span<const ColumnSample> columns, const SpecimenValues& specimen);

}  // namespace triax::lab
