// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// RIG.toml: the instruments of a laboratory's rig, at which line each of them is and what it
// measures. One file serves both sides: `triax serve` puts such instruments on the wire with a
// virtual specimen behind them, `triax run` and `triax record` drive and read them.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/results/quantity.hpp"
#include "lab/wire/asked_value.hpp"
#include "lab/wire/calibration.hpp"
#include "lab/wire/link_address.hpp"
#include "lab/wire/personality.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// One value that is read again and again.
struct RigChannel {
  std::optional<Quantity> quantity;  ///< a raw channel of a test; empty: kept beside it
  std::string name;                  ///< "pore_pressure", or whatever else it is: "room"
  std::string unit;                  ///< of the calibrated value, as the file writes it
  double scale = 1;                  ///< one unit is so many SI units; 1 where unknown
  AskedValue asked;                  ///< where it stands in the instrument
  Calibration calibration;
  bool from_start = false;  ///< counts from what it says at the first reading of a test
  std::int64_t line = 0;
};

/// What an instrument drives, beside what it reads.
enum class RigRole { reads, frame, cell, back };
std::string_view to_text(RigRole role);

struct RigInstrument {
  std::string name;
  LinkAddress link;
  /// Where `triax serve` puts it, if not there: a serial line has two ends.
  std::optional<LinkAddress> served_at;
  Personality personality;
  RigRole role = RigRole::reads;
  std::vector<RigChannel> channels;
  std::int64_t line = 0;
};

/// What `triax serve` puts behind the instruments.
struct RigPlant {
  std::string programme;               ///< specimen, frame, controllers, transducers of this file
  std::optional<std::uint64_t> seed;   ///< in place of the programme's
  double watchdog_s = 3;               ///< see ServedDrives
  std::optional<LinkAddress> control;  ///< where the served rig's clock and faults are turned
};

struct RigFile {
  std::string name, file;
  std::vector<RigInstrument> instruments;
  std::optional<RigPlant> plant;
  double interval_s = 1;  ///< of `triax record`

  /// What stands behind it. Throws BadInput where the rig is none that can be served.
  const RigPlant& served() const;
  const RigInstrument* find(std::string_view instrument) const;
  const RigInstrument* with(RigRole role) const;
  /// The instrument and the channel that measure it; null: none does.
  const RigChannel* channel(Quantity quantity) const;
};

/// Throws BadInput "FILE:LINE: ...": unknown keys and names, a quantity measured twice, two
/// instruments with one role or one link, a channel that its instrument has not.
RigFile parse_rig_file(std::string_view toml, const std::string& file);
RigFile load_rig_file(const std::string& path);

}  // namespace triax::lab
