// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One simulated test, watched as it runs: what was said of the onset before it came, against the
// specimen's truth.
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "bench/detection/trial.hpp"
#include "bench/warning/interruption.hpp"

namespace triax::bench {

inline constexpr std::array<double, 3> kLeft = {0.25, 0.10, 0.05};  ///< shares of the stage's time

/// The forecast that stood when that share of the stage was left.
struct Look {
  double error = 0;      ///< η forecast − true η
  bool covered = false;  ///< by the 90 % interval
};

enum class Instruments { good, standard, cheap };

struct AlarmTrial : TrialHeader {
  Instruments instruments = Instruments::good;
  bool air = false;  ///< in the pores
  Interruption interruption = Interruption::none;
  double interval_s = 0;
  bool lost = false;                 ///< what the specimen did
  bool under_force = false;          ///< load, dead load, spring or held q drove it
  double stage_s = 0;                ///< from the start of the stage to the onset
  std::int64_t stage_readings = 0;   ///< likewise
  double fall_s = 0;                 ///< time of the fall; of the onset where none fell
  std::optional<double> imminent_s;  ///< when it was said and not taken back, before the fall or 10
                                     ///< readings after the onset
  std::array<std::optional<Look>, kLeft.size()> looks;
  std::string said;  ///< levels and when they were said
  // of a control
  /// Of normalised second-order work in shear, measured without noise or steps: near zero the
  /// control came as near to an onset as any error can tell.
  double least_work = 1;
  bool imminent = false;  ///< ever
  bool approaching_at_end = false;
  std::int64_t points = 0, wrong_points = 0;  ///< of second-order work; those under a level
  double lead_s() const { return imminent_s ? fall_s - *imminent_s : 0; }
  bool warned() const { return imminent_s.has_value(); }
  /// Whether the truth is what the list expects: there is nothing to compare with otherwise.
  bool comparable() const { return lost == collapses; }
};

/// What the seed chooses beside varied(): the stress level (× 0.5 to 2), instruments (as they are,
/// or noise and steps as of a logger of 12 bits), time between readings in shear (× 1/4 to 16, from
/// 0.1 to 60 s), air in the pores (of some seeds: saturation of 97.5 to 99 %), a rest or a
/// loop on the way (interruption.hpp).
lab::Programme varied_for_alarm(const Subject& subject, std::uint64_t seed,
                                Instruments& instruments);

AlarmTrial run_alarm_trial(const Subject& subject, std::uint64_t seed);

}  // namespace triax::bench
