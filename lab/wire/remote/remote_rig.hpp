// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The third back end: the stages of a programme on instruments at the other end of wires.
#include <functional>

#include "lab/programmes/programme.hpp"
#include "lab/rig/rig_software.hpp"
#include "lab/wire/remote/remote_apparatus.hpp"

namespace triax::lab {

class RemoteRig : public RigSoftware {
 public:
  static constexpr double kConnect_s = 10;

  /// Waits until every instrument of the rig answers and is what the file says. The header names
  /// each with its calibrations; it is that of a simulated test where one says so of itself. The
  /// programme's faults are not the rig's and are left out. Throws BadInput where the rig lacks
  /// something, WorkFailed where instruments are not there. All but the programme outlive it.
  RemoteRig(LineLoop& loop, const RigFile& rig, const Programme& programme,
            const std::function<bool()>& stop = {});

 private:
  struct Linked;
  explicit RemoteRig(Linked linked);
};

}  // namespace triax::lab
