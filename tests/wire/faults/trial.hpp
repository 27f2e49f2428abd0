// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A trial of the wire: a rig that is served in one thread, a test driven over the wire in another,
// and what goes wrong between them. Both keep a log, on one clock.
#include <string>
#include <utility>
#include <vector>

#include "lab/results/reading.hpp"
#include "lab/rig/apparatus.hpp"

namespace triax::lab::test {

/// What one instrument does wrong, in the words of the control tree.
struct Wrong {
  std::string kind;        ///< for the counts: "silent"
  std::string instrument;  ///< "scanner"
  std::vector<std::string> on, off;
  double from_s = 0, for_s = 0;     ///< since the trial began
  std::vector<std::string> causes;  ///< one of these is told; empty: it need not be noticed
  bool cuts = true;                 ///< no answer can be taken while it lasts
  std::string not_taken_with = {};  ///< once this was told, no value until it is over
};

inline constexpr double kDeadline_s = 0.3, kWatchdog_s = 3;

struct TrialPlan {
  int number = 0;
  bool modbus = false;
  double deadline_s = kDeadline_s;  ///< of all instruments
  bool serial = false;              ///< Modbus RTU, over pairs of pseudo-terminals
  std::vector<Wrong> wrongs;
};

/// Broken code as the checks have to notice it.
enum class Broken { nothing, held_over, other_channel, untold, unsafe, identity };

struct PlantTick {
  double at_s;
  Reading reading;
  double cell_set_pa, back_set_pa;
  bool stopped;  ///< the frame was ordered to
};

/// A look at all instruments and the tick behind it.
struct Look {
  double asked_s = 0, answered_s = 0;
  Reading reading;
  bool running = true;
  std::vector<Event> events;  ///< of the tick
  double over_s = 0;
};

struct TrialLog {
  std::vector<PlantTick> plant;
  std::vector<Look> looks;
  std::vector<Event> events;                      ///< of the rig's software
  std::vector<std::pair<double, double>> lasted;  ///< of each wrong, by the clock
  double safe_s = 0;                              ///< when the rig first rested; 0: never
  double stall_s = 0;  ///< the longest that the machine kept a thread waiting
  std::string failed;  ///< what was thrown
};

/// Seconds on the clock of all logs.
double trial_now_s();
TrialLog run_trial(const TrialPlan& plan, Broken broken);

struct Verdict {
  std::vector<std::string> complaints;
  long cells = 0, missing = 0;
  long told_apart = 0;  ///< cells that differ from what was there a quarter of a second before
  bool safe = false;
};
Verdict judge(const TrialPlan& plan, const TrialLog& log);

/// All trials of the campaign, in an order of their own.
std::vector<TrialPlan> all_trials();

}  // namespace triax::lab::test
