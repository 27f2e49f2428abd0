// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Raw channels -> State; the equations stand in reduction.hpp.
#include <optional>
#include <vector>

#include "lab/reduction/reduction.hpp"

namespace triax::lab {

class RawReduction {
 public:
  /// Throws BadInput if the record is raw and the specimen's height or diameter is missing.
  RawReduction(const RecordHeader& header, const ReductionOptions& options);

  State reduce(const Reading& reading);
  Consolidation consolidation() const;
  std::vector<Warning> warnings() const;
  /// Area at the start of shear; empty before it.
  std::optional<double> start_area() const;

 private:
  /// Dimensions from which strains count, and the counters' readings there.
  struct Reference {
    double height_m = 0, volume_m3 = 0;
    double displacement = 0, back_volume = 0;
    double area() const { return volume_m3 / height_m; }
  };
  void start_stage(const Reading& reading);
  void start_shear(const Reading& reading);
  void correct_for_membrane(State& state) const;
  std::optional<double> void_ratio_at(double volume_m3) const;

  SpecimenInfo specimen_;
  std::vector<StageInfo> stages_;
  ReductionOptions options_;
  Reference as_built_, now_, stage_start_;
  std::optional<int> stage_;
  StageRole role_ = StageRole::unknown;
  bool sheared_ = false;
  /// Where u is read: at the specimen; at the controller in a record without that transducer.
  Quantity pore_channel_ = Quantity::pore_pressure;
  double last_displacement_ = kMissing, last_back_volume_ = kMissing;
  double consolidation_shortening_ = 0;  ///< m, measured by the displacement transducer
  double consolidation_outflow_ = 0;     ///< m³, water out of the specimen while it consolidated
  std::optional<double> p_eff_start_, void_ratio_start_;
  std::vector<Warning> warnings_;
};

}  // namespace triax::lab
