// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The physical side of the virtual rig: specimen, cylinder, crosshead, two pressure/volume
// controllers and the valve, moved on by one tick under given demands. No instrument, no programme.
//
// Within a tick pressures and forces run linearly from their value at its start to that at its end;
// the controllers take in what the specimen gave them in the tick before.
#include <optional>
#include <utility>
#include <vector>

#include "lab/devices/fault.hpp"
#include "lab/devices/pressure_controller.hpp"
#include "lab/programmes/programme.hpp"
#include "sim/specimen/specimen.hpp"

namespace triax::lab {

/// What is asked of the axis for one tick.
struct AxisDemand {
  enum class Kind { free, crosshead, force };
  Kind kind = Kind::free;
  double velocity_m_per_s = 0;  ///< crosshead
  double spring_n_per_m = 0;    ///< crosshead: of a spring between it and the cap; 0: none
  double start_force_n = 0;     ///< force: wanted at the start of the tick
  double force_n = 0;           ///< force: wanted at its end
  /// force: with an area (as seen at the start), `force_n` is besides a stress on the current one:
  /// a servo that follows the area within the tick.
  double area_m2 = 0, start_stress_pa = 0, stress_pa = 0;
  bool dead = false;       ///< force: masses on the piston, which no servo has to follow
  bool perturbed = false;  ///< with inertia from the start of the tick
  double impulse_n_s = 0;
};

struct PlantDemand {
  AxisDemand axis;
  PressureDemand cell, back;
  /// Volume control of the back controller instead: flow out of the specimen, m³/s.
  std::optional<double> outflow_m3_per_s;
  bool valve_open = true;
};

struct PlantState {
  sim::SpecimenState specimen;
  ControllerState cell, back;
  double cylinder_force_n = 0;
};

class Plant {
 public:
  /// Throws std::invalid_argument where the specimen refuses its properties.
  explicit Plant(const Programme& programme);

  /// In place of those of the programme.
  void set_faults(std::vector<Fault> faults) { faults_ = std::move(faults); }
  const sim::Specimen& specimen() const { return specimen_; }
  const PlantState& state() const { return state_; }
  /// The last tick, with its work; empty before the first.
  const sim::SpecimenStep& last_step() const { return step_; }
  /// Moves on by dt; the state stays as it was if the step failed or lost control.
  const sim::SpecimenStep& advance(const PlantDemand& demand, double time_s, double dt_s);
  /// What a perfect instrument would say of the present state; SI.
  double true_value(Quantity channel) const;

 private:
  sim::WaterDrive water(const PlantDemand& demand, double time_s, double dt_s,
                        ControllerState& back) const;
  double next_cylinder_force_n(const AxisDemand& demand, bool stuck, double dt_s) const;
  sim::AxialDrive axis(const AxisDemand& demand, double cylinder_force_n, bool stuck,
                       double dt_s) const;
  void follow_area(const AxisDemand& demand, double dt_s, sim::AxialDrive& drive) const;

  std::vector<Fault> faults_;
  PressureController cell_controller_, back_controller_;
  LoadingFrame frame_;
  sim::Specimen specimen_;
  PlantState state_;
  sim::SpecimenStep step_;
  double cell_inflow_m3_ = 0, back_inflow_m3_ = 0;  ///< of the last tick
};

/// A specimen of ours has no suction, say: such a channel is not on the rig, whatever is described.
Programme as_far_as_simulated(Programme programme);

}  // namespace triax::lab
