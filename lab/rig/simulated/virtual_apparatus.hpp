// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A specimen from sim/ under virtual devices, looked at by virtual transducers: plant and
// instruments, and the truth of what the specimen went through.
#include "lab/rig/apparatus.hpp"
#include "lab/rig/simulated/instruments.hpp"
#include "lab/rig/simulated/truth_log.hpp"

namespace triax::lab {

class VirtualApparatus : public Apparatus {
 public:
  /// Throws BadInput where the specimen refuses the programme's properties.
  VirtualApparatus(const Programme& programme, std::uint64_t seed);

  void look(Reading& reading) override;
  const DeviceStates& devices() const override { return devices_; }
  Ticked tick(const PlantDemand& demand, const Tick& tick) override;
  std::vector<std::string> begin_shear() override;
  /// See TruthWatch and RunAwayLog. Where the cap fell before second-order work turned, the
  /// specimen lost its equilibrium where that began.
  std::optional<Truth> truth() const override;

  /// In place of those of the programme, from the next look and tick on.
  void set_faults(const std::vector<Fault>& faults);

  /// The physical side, at the end of the last tick.
  const Plant& plant() const { return plant_; }

 private:
  bool survived(const sim::SpecimenStep& step, const Tick& tick, Ticked& done);
  void keep_within_travel(const sim::SpecimenStep& step, const Tick& tick, Ticked& done);
  static void warn_once(bool& told, const std::string& text, Ticked& done);
  void ask_devices();

  MaterialSet material_;
  std::string source_;
  double built_height_m_, travel_m_;
  Plant plant_;
  Instruments instruments_;
  TruthLog truth_;
  DeviceStates devices_;
  std::optional<double> shear_height_m_;  ///< at the start of the first shear stage
  bool lies_ = false;                     ///< the cap lies on the stop
  bool cavitation_warned_ = false, accuracy_warned_ = false;
};

}  // namespace triax::lab
