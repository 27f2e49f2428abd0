// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The instruments of a rig's file on the wire, with a virtual specimen between them: each on its
// own port, one plant behind all, and a control tree for its clock and its faults.
//
// In real time the plant moves in ticks of kTick_s of the clock, no longer than RigSoftware's; each
// tick is one look at the transducers, and every question is answered from the latest. What a slow
// plant cannot make good within kMostLate_s is left out, and lost_s() tells. In lock step only
// CLOCk:STEP? moves it.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/wire/line/wire_server.hpp"
#include "lab/wire/scpi/table.hpp"
#include "lab/wire/served/served_instrument.hpp"

namespace triax::lab {

struct ServingOptions {
  std::string listen = "127.0.0.1";  ///< where TCP links listen, whatever the file's host
  bool lock_step = false;
  double speed = 1;  ///< test time runs so many times faster than the clock
  int clients = 64;  ///< of one instrument
};

class ServedRig {
 public:
  static constexpr double kTick_s = 0.02;
  static constexpr double kMostLate_s = 1;

  /// Listens at once; nothing is answered before the loop runs. `programme` is that of the rig's
  /// [plant], whose seed replaces its own; rig and loop outlive this. Throws BadInput where the rig
  /// has no [plant] or an instrument cannot be served, WorkFailed where an address is taken.
  ServedRig(LineLoop& loop, const RigFile& rig, const Programme& programme,
            const ServingOptions& options);
  ~ServedRig();
  ServedRig(const ServedRig&) = delete;
  ServedRig& operator=(const ServedRig&) = delete;

  struct Open {
    std::string name;
    LinkAddress link;  ///< as taken
  };
  /// What is open, the control last.
  const std::vector<Open>& open() const;
  const ServedPlant& plant() const;
  /// Of the clock's time that the plant was too slow for, s.
  double lost_s() const;
  /// The control tree.
  const ScpiTable& control() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab
