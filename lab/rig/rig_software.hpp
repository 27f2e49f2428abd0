// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The software of a rig: runs the stages of a programme on an apparatus, virtual or on the wire,
// and knows readings only (seen.hpp).
//
// Between scans time passes in ticks of at most kTick_s. At the start of each the instruments are
// looked at, the supervision has its say, the loops ask for what the stage wants. A stage ends at a
// scan; the reading at which an end is met is the last of its stage. Everything is held in a few
// values: memory does not grow with the test.
//
// Channels: axial displacement and volumes count from the start of the test; axial force is that of
// an internal load cell, above the cell pressure; volumes are what the controllers' pistons pushed
// out, into specimen and cell.
//
// Held or in its safe state the rig locks the crosshead and holds both pressures, in a stage of its
// own (the last of the header) of which nothing is judged. After a hold the test goes on where it
// was; the guard's hold ends it (guard.hpp); the safe state ends it after kSafeReadings. So many
// readings follow, in the same stage, after a cap that ran away has come to lie on the stop at the
// end of its travel.
#include <memory>
#include <optional>
#include <string>

#include "lab/rig/apparatus.hpp"
#include "lab/rig/back_end.hpp"
#include "lab/rig/guard_stages.hpp"

namespace triax::lab {

/// How a test ended, as far as the software of the rig knows.
struct TestEnding {
  enum class Kind {
    completed,   ///< by its end conditions, its guard, or a specimen that ran away or cannot follow
    safe_state,  ///< an instrument, a drive or this program failed
    aborted,     ///< by the operator
    unfinished   ///< a stage came to its time limit, or the crosshead to the end of its travel
  };
  Kind kind = Kind::completed;
  std::string reason;  ///< a sentence; empty if completed
};

class RigSoftware : public BackEnd {
 public:
  static constexpr double kTick_s = 0.25;
  static constexpr int kSafeReadings = 10;

  /// Throws BadInput where there is no stage.
  RigSoftware(const GuardedProgramme& programme, RecordHeader header,
              std::unique_ptr<Apparatus> apparatus);
  ~RigSoftware() override;

  const RecordHeader& header() const override;
  /// A stage that does not reach its end, the end of the travel and a control that the specimen
  /// does not allow end the test with a warning in the header; a device that fails leads to the
  /// safe state. Throws what the apparatus throws.
  bool next(Reading& reading) override;
  double progress() const override;
  std::optional<Truth> truth() const override;
  /// What happened to the rig since the last call.
  std::vector<Event> events() override;
  /// CheckKind::stage_target of each stage that ended at a pressure other than its target.
  std::vector<Check> checks() const override;

  /// Pauses, goes on, or leads to the safe state, from the next tick on. `by` says who asked, for
  /// the event. False where nothing changes: it is so already, or in the safe state.
  bool hold(const std::string& by = "from outside");
  bool resume(const std::string& by = "from outside");
  bool stop_safely(const std::string& by);
  bool abort(const std::string& reason) override;
  /// The guard of the programme acts in a stage that it guards, from the next tick on; a stage that
  /// would begin while its level stands is not left to its load for a tick.
  void heed(WarningLevel level) override;
  std::optional<std::string> guarded() override;
  /// Pre-condition: next() returned false, or abort() was called.
  const TestEnding& ending() const;

 protected:
  const Apparatus& apparatus() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab
