// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the software of a rig (rig_software.hpp) drives: frame, controllers, valve and transducers,
// with a virtual specimen between them or with a real one at the other end of the wires.
#include <optional>
#include <string>
#include <vector>

#include "lab/programmes/programme.hpp"
#include "lab/results/reading.hpp"
#include "lab/results/summary.hpp"
#include "lab/rig/demand.hpp"
#include "lab/rig/device_states.hpp"

namespace triax::lab {

/// One tick as the software means it.
struct Tick {
  const Stage& stage;
  double time_s = 0;  ///< test time at its start
  double dt_s = 0;
  bool running = true;        ///< false while held or in the safe state
  std::int64_t readings = 0;  ///< so far
};

/// What became of a tick.
struct Ticked {
  enum class End {
    none,
    cut,       ///< it went no further than its start: nothing can be driven on
    stopped,   ///< at the end of the travel, in the way of the crosshead
    lies_down  ///< a cap that ran away lies on the stop; it can still be read
  };
  double passed_s = 0;  ///< test time
  End end = End::none;
  std::string why;                    ///< of an end, a whole sentence
  std::vector<std::string> warnings;  ///< for the record
  std::vector<Event> events;          ///< a runaway, a link that is lost or is back; no reading yet
};

class Apparatus {
 public:
  virtual ~Apparatus() = default;
  Apparatus() = default;
  Apparatus(const Apparatus&) = delete;
  Apparatus& operator=(const Apparatus&) = delete;

  /// Fills the raw channels of `reading`, which holds test time and stage; NaN: not read. Sets the
  /// time to that at which they were taken, where that is another.
  virtual void look(Reading& reading) = 0;
  /// As of the last look or tick.
  virtual const DeviceStates& devices() const = 0;
  /// Demands this for one tick and lets it pass. Throws WorkFailed where nothing can be kept.
  virtual Ticked tick(const PlantDemand& demand, const Tick& tick) = 0;
  /// The test is over, or broken off: brings what moves to a stand. Throws nothing.
  virtual void rest() {}
  /// The first shear stage begins; returns warnings for the record.
  virtual std::vector<std::string> begin_shear() { return {}; }
  /// See BackEnd::truth.
  virtual std::optional<Truth> truth() const { return std::nullopt; }
};

}  // namespace triax::lab
