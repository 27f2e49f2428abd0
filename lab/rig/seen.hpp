// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the rig's own software knows: the latest readings, reduced as in a report. Control loops and
// ends of stages look at nothing else, so that a dead transducer misleads them as it would in a
// laboratory.
#include <array>

#include "lab/programmes/end_condition.hpp"
#include "lab/reduction/raw_reduction.hpp"

namespace triax::lab {

class Seen {
 public:
  /// Share of the area; a specimen that has not lost control stays far below it from look to look.
  static constexpr double kLeap = 2e-3;

  explicit Seen(const RecordHeader& header);

  /// The next look, at a raw reading with its time and stage. A channel in a gap (NaN) keeps its
  /// last value, as a controller's register does.
  void take(const Reading& reading);
  /// From here on time, rates and B count anew.
  void begin_stage();
  /// Time of the stage runs by what is added here: not during a pause.
  void add_stage_time(double dt_s) { stage_time_s_ += dt_s; }

  double operator[](Quantity channel) const { return held_[channel]; }
  const State& state() const { return state_; }
  double stage_time_s() const { return stage_time_s_; }
  /// The area for a control loop: a leap by more than kLeap is believed from the second look on, so
  /// that a spike moves no force.
  double steady_area_m2() const { return area_; }
  /// That area as expected one look later, from the last two.
  double next_area_m2() const;
  /// SI; NaN while unknown (a rate before half a minute, B before σ_c has moved).
  double value(EndQuantity quantity) const;
  /// Met now and at the look before, so that no single spike ends a stage; a time counts at once.
  bool met(const EndCondition& end) const;

 private:
  struct Mark {  ///< where a rate is counted from
    double time_s = kMissing, volume = 0, displacement = 0;
  };
  using Values = std::array<double, kEndQuantityCount>;
  Values values() const;
  void count_rates();
  void take_area();

  RawReduction reduction_;
  Reading held_;
  State state_;
  double area_ = kMissing, area_before_ = kMissing;
  bool leapt_ = false;
  double stage_time_s_ = 0;
  Mark mark_;
  double volume_rate_ = kMissing, axial_rate_ = kMissing;
  double cell_at_start_ = kMissing, pore_at_start_ = kMissing;
  Values before_, now_;
};

}  // namespace triax::lab
