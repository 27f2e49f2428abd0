// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// States as formulas of the readings.
#include <optional>
#include <variant>

#include "db/store.hpp"
#include "lab/measured/specimen_volume.hpp"
#include "src/export/workbook/raw_trail.hpp"
#include "src/export/workbook/reduced_trail.hpp"
#include "src/export/workbook/work_cells.hpp"

namespace triax::src {

class StatesSheet {
 public:
  StatesSheet(Sheet& sheet, const db::StoredTest& test, const SpecimenTerms& specimen,
              std::size_t first_reference_row, std::size_t first_reading_row,
              const WorkWindows& windows, std::vector<lab::SecondOrderWorkPoint> points);

  /// In the order of the readings.
  void write(std::size_t row, const lab::Reading& reading, const lab::State& state);
  /// Empty where the record was reduced before.
  const std::vector<ReferenceRow>& references() const;
  const WorkCells& work() const { return work_; }
  static std::size_t column(StateCell place);

 private:
  void keep_states(const ReducedTerms& s, const lab::Reading& reading, const lab::State& state,
                   StateTerms& row) const;
  void keep_path(const lab::State& state, StateTerms& row);
  void keep_volume(const lab::State& state, StateTerms& row);
  double stored_value(std::size_t at, const lab::State& state) const;

  Sheet& sheet_;
  lab::RecordHeader header_;
  std::size_t first_reading_row_;
  const WorkWindows& windows_;
  std::vector<lab::SecondOrderWorkPoint> points_;
  std::variant<RawTrail, ReducedTrail> trail_;
  WorkCells work_;
  lab::SpecimenVolume volume_;
  std::size_t next_window_ = 0, next_point_ = 0;
  const lab::SecondOrderWorkPoint* point_ = nullptr;  ///< of the row under way
  Term path_, last_strain_;
};

}  // namespace triax::src
