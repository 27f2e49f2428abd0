// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The alarm: beside the monitor, which judges, it looks ahead. What it says it says at once.
#include <functional>
#include <optional>
#include <vector>

#include "lab/collapse/limit_surface.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/summary.hpp"
#include "lab/warning/cyclic_warning.hpp"
#include "lab/warning/warning_levels.hpp"

namespace triax::lab {

/// What the alarm tells as it watches. Any may be empty.
struct AlarmListener {
  /// The forecast of η, where there is one: at every point of second-order work, and where a level
  /// is reached or left; never twice at one reading.
  std::function<void(const Forecast&)> foreseen;
  /// A level was reached or taken back.
  std::function<void(const Event&)> happened;
};
using AlarmListeners = std::vector<AlarmListener>;

/// Watches every state as it is scanned, in constant memory. The monitor's states have waited until
/// nothing more can come to light about their sensors, four readings at least; here a reading that
/// turns out to be wrong costs a level that is taken back, and one that waits would cost the
/// specimen.
class Alarm {
 public:
  /// `earlier`: of the same sand, as far as anybody says.
  explicit Alarm(const RecordHeader& header, AlarmListeners listeners = {},
                 const EarlierTests& earlier = {});
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

  void watch(const State& measured);
  /// A sensor cannot be believed: what was forecast is forgotten, a level taken back.
  void interrupt(const std::string& reason);
  /// The specimen was lost, as the monitor found.
  void lose();

  /// The higher one of the forecast of η and of the cyclic warning.
  WarningLevel level() const;
  /// Where the levels that stand, or stood when the specimen was lost, were said first.
  const std::optional<Forecast>& approaching() const { return approaching_; }
  const std::optional<Forecast>& imminent() const { return imminent_; }

 private:
  void start_stage(const State& state);
  bool is_cyclic_watched(const StageInfo* stage) const;
  void watch_cycles(const State& state, WarningLevel before);
  Forecast cyclic_forecast(const State& state) const;
  std::optional<Forecast> current_forecast(const State& state) const;
  void take_back(const State& state, const std::string& reason);
  void say(const State& state);

  const RecordHeader header_;
  const AlarmListeners listeners_;
  LimitSurface limit_;
  SpecimenVolume volume_;
  WarningLevels levels_;
  CyclicWarning cyclic_;
  bool is_lost_ = false;  ///< since the start of shear
  std::optional<int> stage_;
  std::optional<State> latest_;
  std::optional<Forecast> approaching_, imminent_;
};

}  // namespace triax::lab
