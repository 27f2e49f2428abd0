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
#include "lab/rig/demand.hpp"
#include "sim/specimen/specimen.hpp"

namespace triax::lab {

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
