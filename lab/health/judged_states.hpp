// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between reduction and monitor: states on live sensors pass, the others do not.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/health/closed_drainage.hpp"
#include "lab/health/plausibility.hpp"
#include "lab/health/record_health.hpp"
#include "lab/health/unmeasured_volume.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Holds states back while one of their sensors is in doubt (at most kHeld readings) and leaves out
/// those on a sensor that was dead. Readings and states themselves are not touched. After a longer
/// stretch of dead readings judgement goes on only where nothing that counts as a collapse can hide
/// in it: q and p′ changed by less than a tenth, the axial strain by less than 1 %; else it ends
/// there. A shorter one, in which a sensor died, ends it where no live reading of shear follows. It
/// ends too where displacement or volume, which count from the start of shear, was dead
/// then, and where a specimen whose drainage is shut turns out not to be undrained, or nobody reads
/// any more whether it is.
class JudgedStates {
 public:
  static constexpr std::int64_t kHeld = 1024;

  struct Judged {
    Judged(const Reading& its_reading, const State& its_state)
        : reading(its_reading), state(its_state) {}
    Reading reading;
    State state;
    ChannelSet wrong = 0;     ///< channels that cannot be believed at this reading
    bool live = true;         ///< the state can be judged
    bool dead = false;        ///< not live because a sensor is stuck or saturated, or impossible
    bool impossible = false;  ///< no specimen of any soil can be in this state (Plausibility)
    bool after_gap = false;   ///< first of its kind after a longer stretch that could not
    bool no_origin = false;   ///< a sensor whose readings count from the start of shear is wrong
    /// Not live, but in shear, and displacement, load and cell pressure can be believed: what the
    /// axis did is known (axis_of).
    bool axis_live = false;
    /// What was found before this state is to be kept: the verdict may come to end there.
    bool mark = false;
    std::string reason{};  ///< why it is not live
  };

  explicit JudgedStates(const RecordHeader& header);

  void add(const Reading& reading, const State& state);
  /// The next one about which all is known; null until more readings came. Valid until the next
  /// call of add() or next().
  const Judged* next();
  /// No more readings will come: next() gives the rest. Findings as after add().
  void finish();

  /// False if no specimen can be in this state of shear, as far as is known by now: nothing may be
  /// concluded from it, at once or later.
  bool is_possible(const State& state) const;

  const RecordHealth& health() const { return health_; }
  /// Channels that could not be believed at the first reading of shear, and at any of a B check.
  ChannelSet wrong_at_shear() const { return wrong_at_shear_; }
  ChannelSet wrong_in_b_check() const { return wrong_in_b_check_; }
  /// Whether what the axis showed stands where the verdict does not: no sensor behind it turned out
  /// to have been dead, and nothing was implausible.
  bool trusts_axis() const;
  /// The verdict is what was found before the last mark.
  bool ends_at_mark() const { return ends_at_mark_; }
  /// Writes into the verdict how far it reaches, and takes it back where a sensor turned out to
  /// have been dead among states that had already been judged. Call after the last next().
  void bound(Collapse& collapse) const;
  /// "no verdict after reading 230 ...", where that is so.
  std::vector<Warning> warnings() const;

 private:
  struct End {
    std::int64_t last = -1;  ///< last judged reading; -1: none
    std::string reason;
  };
  std::span<Judged> held() { return std::span(held_).subspan(first_); }
  void drop_first();
  bool spoils(const SensorFinding& finding, int stage) const;
  void mark(const RecordHealth::Wrong& wrong);
  void note_volume_gauge(const Reading& reading);
  void check_state(Judged& entry);
  bool watch_drainage(Judged& entry, const StageInfo* stage);
  void end_undrained(const std::optional<ClosedDrainage::Doubt>& doubt);
  void judge(Judged& entry);
  bool shows_axis(const Judged& entry) const;
  std::string withheld() const;
  bool may_go_on(const State& state) const;
  std::optional<End> end() const;

  RecordHeader header_;
  RecordHealth health_;
  std::vector<Judged> held_;
  std::size_t first_ = 0;  ///< of held_: those before were returned and dropped
  bool taken_ = false;     ///< next() returned the first one
  bool finished_ = false;
  std::optional<State> last_live_;  ///< the last that was judged, in shear
  std::int64_t judged_last_ = -1;   ///< number of the last reading that was judged
  std::int64_t judged_first_ = -1;  ///< and of the first
  UnmeasuredVolume volume_;
  ClosedDrainage drainage_;
  Plausibility plausibility_;
  bool ends_at_mark_ = false;
  std::optional<int> stage_;  ///< of the last reading
  bool gauge_rests_ = false;  ///< no volume is logged in this stage, where the drainage is shut
  bool gauge_was_absent_ = false;  ///< at the last reading
  std::int64_t left_out_ = 0;      ///< readings since last_live_
  std::string gap_reason_;
  bool died_ = false;  ///< the last of those was on a sensor that is stuck or saturated
  ChannelSet wrong_at_shear_ = 0, wrong_in_b_check_ = 0;
  bool sheared_ = false;
  std::optional<End> end_;
  bool drainage_was_said_ = false;      ///< of the last stage with the valve shut
  std::string doubt_of_what_was_said_;  ///< that the drainage is closed; empty: none
  std::string withheld_;                ///< why the verdict cannot stand; empty: it can
  bool axis_was_dead_ = false;          ///< among states that had been judged
};

/// The reading without the channels that cannot be believed.
Reading believed(const JudgedStates::Judged& judged);

/// The state without what stands on channels that cannot be believed: the axial strain remains.
/// Pre-condition: axis_live.
State axis_of(const JudgedStates::Judged& judged);

}  // namespace triax::lab
