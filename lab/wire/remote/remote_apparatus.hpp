// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Frame, controllers and transducers at the other end of wires, as the rig's software drives them.
//
// All instruments are asked at one instant and their answers awaited together. What is late or
// wrong is a missing cell, and an event tells its cause and when it is over. What the software
// demands is set where it has changed; a device whose link was lost is told again. A device that
// drives and gives no good answer for Supervision::kDeaf_s has failed, whatever else reads. This
// program itself has failed once it stood still for so long.
//
// Time is the clock's times `speed`, or, in lock step, turned by the client (served rigs only).
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/rig/apparatus.hpp"
#include "lab/wire/remote/absences.hpp"
#include "lab/wire/remote/control_line.hpp"
#include "lab/wire/remote/drive_settings.hpp"
#include "lab/wire/remote/instrument_clocks.hpp"
#include "lab/wire/remote/wire_instruments.hpp"

namespace triax::lab {

class RemoteApparatus : public Apparatus {
 public:
  /// `stop` breaks off waiting. All outlive it. Throws BadInput where the rig lacks a drive or a
  /// channel that every test needs.
  RemoteApparatus(LineLoop& loop, const RigFile& rig, const Programme& programme,
                  std::function<bool()> stop = {});

  /// Waits until every instrument is ready; throws WorkFailed with all that are not and why.
  void connect(double within_s);
  ~RemoteApparatus() override;
  const WireInstruments& instruments() const { return instruments_; }

  void look(Reading& reading) override;
  const DeviceStates& devices() const override { return devices_; }
  Ticked tick(const PlantDemand& demand, const Tick& tick) override;
  /// Stops the crosshead and holds both pressures.
  void rest() override;

 private:
  static constexpr int kRefusals = 3;  ///< of one order in a row, before the rig is unsafe
  static constexpr double kOrderPatience_s = 2;  ///< until an order is taken, or given again

  double test_time_s(double loop_s, const Reading& reading) const;
  void take(const WireInstrument& one, const WireInstrument::Scan& scan, Reading& reading);
  void take_states(RigRole role, const std::vector<double>& said);
  double awaited_until_s(const WireInstrument& one) const;
  void look_for_stall(double stall_s);
  void look_for_deaf_drives();
  void drive(RigRole role, const DriveSettings& settings);
  void await(const std::function<bool()>& done, double within_s);
  double pass(const Tick& tick);
  void follow_ramps(const PlantDemand& demand, double dt_s);
  void end_by_state(const Tick& tick, Ticked& done);

  struct Sent {
    int link = 0;  ///< over which it went
    DriveSettings settings;
  };
  LineLoop& loop_;
  const RigFile& rig_;
  Programme programme_;
  std::function<bool()> stop_;
  WireInstruments instruments_;
  std::unique_ptr<ControlLine> control_;
  RigTime time_;
  std::optional<double> start_s_;  ///< of the test, on the loop's clock
  DeviceStates devices_;
  double displaced_m_ = 0;  ///< as last read
  FrameState frame_state_ = FrameState::ready;
  Ticked::End told_end_ = Ticked::End::none;
  std::map<RigRole, Sent> sent_;
  std::size_t orders_ = 0;             ///< under way
  std::map<RigRole, int> refusals_;    ///< in a row
  std::string refused_;                ///< why, the last
  std::map<Quantity, double> starts_;  ///< of channels that count from the start of the test
  Absences absences_;
  InstrumentClocks clocks_;
  std::map<const WireInstrument*, double> heard_s_;  ///< its last whole scan, on the loop's clock
};

}  // namespace triax::lab
