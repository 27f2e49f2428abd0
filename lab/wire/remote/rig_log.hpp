// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Only reads and keeps, while another program controls: the channels of a rig at an interval, in
// triax's own CSV. What is no raw channel of a test stands behind those in columns of its own,
// "room_degC". A row is in the file as soon as it was read: a logger that is killed loses nothing.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lab/wire/rig_file.hpp"

namespace triax::lab {

struct RigLogOptions {
  double interval_s = 1;
  double for_s = 0;           ///< how long; 0: until `stop`
  std::int64_t readings = 0;  ///< how many; 0: until then
  std::function<bool()> stop = {};
  /// A gap with its cause, and its end; rows that are missed: a sentence each.
  std::function<void(const std::string&)> say = {};
  std::function<void(std::int64_t readings, double time_s)> progressed = {};
};

struct RigLogged {
  std::int64_t readings = 0;
  std::int64_t missing_cells = 0;
  bool simulated = false;
  bool stopped = false;  ///< by `stop`, before all was read that was asked for
  /// Instruments that gave no readings at the last row, with the cause: "cell: no answer within 1
  /// s".
  std::vector<std::string> silent;
};

/// Throws BadInput where the file is there already, WorkFailed where it cannot be written or no
/// instrument answers. Rows that are due while all instruments are away are rows of empty cells.
RigLogged log_rig(const RigFile& rig, const std::string& path, const RigLogOptions& options);

}  // namespace triax::lab
