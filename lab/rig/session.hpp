// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The one stream: back end -> Reading -> reduction -> State -> collapse monitor -> Event, told to
// recorder, progress bar and panel as it runs.
#include <functional>

#include "lab/reduction/reduction.hpp"
#include "lab/rig/back_end.hpp"
#include "lab/rig/session_listener.hpp"
#include "lab/warning/earlier_tests.hpp"

namespace triax::lab {

/// What a test comes to with another answer to something that its record does not say.
struct Otherwise {
  std::string taken;  ///< "stage 5 was taken as shear, drainage closed"
  std::string said;   ///< the other answer: "stages.5.drainage=open"
  Collapse collapse;
};

struct SessionOptions {
  ReductionOptions reduction;
  double speed =
      0;  ///< 0: as fast as possible; else test time runs this many times faster than the clock
  /// Asked after every reading and while the clock is waited for; true breaks the test off.
  std::function<bool()> stop = {};
  /// Asked once where the test was judged. A verdict that another answer contradicts, collapse
  /// against none, is withheld, and both are named.
  std::function<std::vector<Otherwise>()> otherwise = {};
  /// Asked once where the guard of the programme acted.
  std::function<GuardOutcome::Without()> without_guard = {};
  /// What the alarm knows of the sand before the test. The verdict does not depend on it.
  EarlierTests earlier = {};
};

/// Runs a whole test; returns what it came to. A test that was broken off is judged as far as it
/// went, with a warning that says when. Throws what the back end or a listener throws, after which
/// every reading that was told stands. The listeners are told in this thread, in their order.
TestSummary run_session(BackEnd& back_end, const SessionOptions& options,
                        const SessionListeners& listeners = {});

}  // namespace triax::lab
