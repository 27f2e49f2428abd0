// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where readings come from: a file (recorded), a specimen from sim/ (virtual) or instruments
// (remote). All three look the same from here on.
#include <optional>
#include <string>
#include <vector>

#include "lab/results/reading.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

class BackEnd {
 public:
  virtual ~BackEnd() = default;
  BackEnd() = default;
  BackEnd(const BackEnd&) = delete;
  BackEnd& operator=(const BackEnd&) = delete;

  /// Known before the first reading. May gain warnings while readings are drawn.
  virtual const RecordHeader& header() const = 0;
  /// Draws the next reading into `reading`; false at the end of the test. Throws BadInput (status
  /// 2) or WorkFailed (status 1); readings drawn before stay valid.
  virtual bool next(Reading& reading) = 0;
  /// Progress in [0, 1], where it is known.
  virtual double progress() const = 0;
  /// What the specimen itself did, complete once next() has returned false; only simulations know.
  virtual std::optional<Truth> truth() const { return std::nullopt; }
  /// What happened to the rig itself since the last call: held, safe state, run-away.
  virtual std::vector<Event> events() { return {}; }
  /// What it checked itself, beside the checks of the readings, up to the reading last drawn.
  virtual std::vector<Check> checks() const { return {}; }
  /// The alarm has come to this level by the reading last drawn, or back to none: a back end that
  /// drives something does what the guard of its programme asks for, once a test.
  virtual void heed(WarningLevel /*level*/) {}
  /// What the guard did since the last call, in words; empty: nothing.
  virtual std::optional<std::string> guarded() { return std::nullopt; }
  /// The test is broken off after the reading last drawn: no more readings are asked for. `reason`
  /// is a whole sentence for the record; a back end that drives something brings it to rest. True
  /// if a warning of its header says so from now on.
  virtual bool abort(const std::string& /*reason*/) { return false; }
};

}  // namespace triax::lab
