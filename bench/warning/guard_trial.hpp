// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One simulated test twice: as it is, and with a guard that hands the load over to the crosshead
// when `imminent` is said.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/detection/trial.hpp"
#include "lab/warning/earlier_tests.hpp"

namespace triax::bench {

struct GuardTrial : TrialHeader {
  static constexpr double kRate_m_per_s = 0.05e-3 / 60;
  static constexpr double kAsked = 0.005;   ///< axial strain that the guard goes on for
  static constexpr double kAllowed = 0.01;  ///< further axial strain of a specimen that was caught

  bool lost = false;               ///< what the specimen did without a guard
  bool under_force = false;        ///< load, dead load, spring or held q drove its last shear
  std::optional<double> fall_s;    ///< of the runaway without a guard
  bool shown = false;              ///< by three readings after it
  std::optional<int> known_after;  ///< readings from the fall to the event `lost`, without it
  bool said_lost = false;          ///< that event, ever
  std::optional<double> acted_s;   ///< the guard
  double further_strain = 0;       ///< from where it acted to the end, of either sign
  bool ran_away = false;           ///< after it had acted

  std::optional<lab::EarlierTest> earlier;  ///< what it says to tests that come after it

  bool comparable() const { return lost == collapses; }
  bool in_time() const { return acted_s && (!fall_s || *acted_s < *fall_s); }
  bool caught() const { return in_time() && !ran_away && further_strain < kAllowed; }
};

GuardTrial run_guard_trial(const Subject& subject, std::uint64_t seed);
/// The guarded part of it anew, of an alarm that knows of earlier tests.
void run_guarded(const Subject& subject, const lab::EarlierTests& earlier, GuardTrial& trial);

/// Tables by what drives the test; with `failures` the tests that were not caught, by name.
void print_guard_trials(const std::string& title, const std::vector<GuardTrial>& trials,
                        bool failures);

}  // namespace triax::bench
