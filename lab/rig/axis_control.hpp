// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The control loop of the axis: from the stage and what was seen to what the axis is asked for.
// What each way to drive it wants is in lab/programmes/axial_way.cpp:
//
//   load          F = F at the start + rate · t
//   constant_q    F = q A
//   stress_ratio  F = η σ₃′/(1 − η/3) A
//   dead_load     F as it is (the masses are chosen so)
//
// A is read, smoothed over the servo's filter and expected at the end of the tick; σ₃′ is the cell
// pressure asked for then less the pore pressure read. A servo adds to its demand what the load
// cell says is missing, at kTrim_per_s, so that a wrong load cell gives a wrong force. Filter and
// trim are slow on purpose: what of the readings' noise goes into the force wobbles the specimen.
// An ideal servo does not wait for the next look: within the tick it follows the area itself, and q
// or η is held at every instant.
#include "lab/programmes/programme.hpp"
#include "lab/rig/demand.hpp"
#include "lab/rig/seen.hpp"
#include "lab/rig/trend_filter.hpp"

namespace triax::lab {

class AxisControl {
 public:
  static constexpr double kTrim_per_s = 0.002;

  struct Servo {
    bool ideal = false;   ///< see above
    double filter_s = 0;  ///< over which the area is smoothed; 0: not at all
  };
  AxisControl() = default;
  explicit AxisControl(const Servo& servo) : servo_(servo), area_(servo.filter_s) {}

  /// A new stage takes over from what is; `true_force_n` is what stands on the piston.
  void begin_stage(const Stage& stage, const Seen& seen, double true_force_n);
  /// Goes on after a pause, from the force that stands on the piston then.
  void resume(const Seen& seen, double true_force_n);
  /// For the tick from now to dt later; `next_cell_pa` is the cell pressure asked for then.
  AxisDemand demand(const Seen& seen, double next_cell_pa, double dt_s);
  /// What the load cell is to read at the end of the tick: a servo's aim, or the masses put on or
  /// taken off at the start of the stage; empty where no force is prescribed.
  std::optional<double> wanted_force_n() const { return wanted_; }

 private:
  void want(const AxisView& view);
  void smooth_area(const Seen& seen, double dt_s);
  bool follows_area() const;
  void follow_area(const Seen& seen, double start_stress, AxisDemand& d) const;

  Servo servo_;
  TrendFilter area_;
  double next_area_ = 0;
  Stage stage_;
  double force_at_start_ = 0;  ///< as read
  double dead_force_ = 0;      ///< as it is
  double q_at_start_ = 0;
  double trim_ = 0;
  double stress_ = 0;  ///< wanted at the end of the last tick, where the area is followed
  bool first_ = true;
  std::optional<double> wanted_;
};

}  // namespace triax::lab
