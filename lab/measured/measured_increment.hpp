// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The increment that a test itself was going through at one of its readings.
#include <cstdint>
#include <numbers>
#include <optional>

#include "lab/measured/path_rates.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/measured/specimen_volume.hpp"

namespace triax::lab {

/// Direction and second-order work of the measured path at a reading, from the windows of PathRates
/// on both sides of it.
struct MeasuredIncrement {
  PathStep rate;  ///< of q, p′ (Pa) and strains, per unit of progress or from one span to the next
  /// Rendulic angle of (√2 dσ₃′, dσ₁′) as in sim/stability/probe.hpp, rad in [0, 2π).
  double angle = 0;
  double angle_error = 0;            ///< standard error, rad
  double normalised = 0;             ///< dσ′:dε/(|dσ′| |dε|), Eq. (23)
  double normalised_error = 0;       ///< standard error
  std::int64_t window_readings = 0;  ///< of the longer of the windows

  /// Beyond 45° of error the direction could be any.
  bool has_direction() const { return angle_error < std::numbers::pi / 4; }
};

/// Of a step along the path: its direction and second-order work, from the standard errors of its
/// stresses and that of its normalised work. Empty where the stresses stand still.
std::optional<MeasuredIncrement> increment_of(const PathStep& step, double p_error, double q_error,
                                              double normalised_error,
                                              std::int64_t window_readings);

/// Takes the states of a test one at a time, in constant memory.
class IncrementWatch {
 public:
  IncrementWatch(const RecordHeader& header, std::int64_t reading);
  IncrementWatch(const IncrementWatch&) = delete;
  IncrementWatch& operator=(const IncrementWatch&) = delete;

  void watch(const State& state);
  /// No more states will come. Empty where no window reaches the reading (outside shear, or too few
  /// readings), or where the stresses stand still.
  std::optional<MeasuredIncrement> finish();

 private:
  void start_stage(const State& state);
  void take(const PathPoint& point);

  RecordHeader header_;
  double reading_;
  SpecimenVolume volume_;
  PathSampler sampler_;
  PathRates rates_;
  std::optional<int> stage_;
  bool passed_ = false;  // nothing that follows bears on the reading
  std::optional<PathPoint> before_, after_;
};

}  // namespace triax::lab
