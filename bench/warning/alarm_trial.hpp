// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One simulated test, watched as it runs: what was said of the onset before it came, against the
// specimen's truth.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/detection/trial.hpp"
#include "bench/warning/interruption.hpp"
#include "lab/rig/session.hpp"

namespace triax::bench {

inline constexpr std::array<double, 3> kLeft = {0.25, 0.10, 0.05};  ///< shares of the stage's time

/// The forecast that stood when that share of the stage was left.
struct Look {
  double error = 0;      ///< η forecast − true η
  bool covered = false;  ///< by the 90 % interval
  double now = 0;        ///< η when it was made
};

enum class Instruments { good, standard, cheap };

struct AlarmTrial : TrialHeader {
  Instruments instruments = Instruments::good;
  bool air = false;  ///< in the pores
  Interruption interruption = Interruption::none;
  double interval_s = 0;
  std::string density;               ///< the subject's void ratio
  bool lost = false;                 ///< what the specimen did
  bool under_force = false;          ///< load, dead load, spring or held q drove it
  double eta = 0;                    ///< true, at the onset
  double stage_s = 0;                ///< from the start of the stage to the onset
  std::int64_t stage_readings = 0;   ///< likewise
  double fall_s = 0;                 ///< time of the fall; of the onset where none fell
  std::optional<double> imminent_s;  ///< when it was said and not taken back, before the fall or 10
                                     ///< readings after the onset
  std::array<std::optional<Look>, kLeft.size()> looks;
  std::string said;  ///< levels and when they were said
  // of a control
  /// Of the specimen's own normalised second-order work (TrueWork), and the 95 % error of that
  /// which the instruments measured there.
  double least_work = 1, work_error = 0;
  bool imminent = false;  ///< ever
  bool approaching_at_end = false;
  std::int64_t points = 0, wrong_points = 0;  ///< of second-order work; those under a level
  /// "inl2" of "inl2/S28-general".
  std::string law() const { return material.substr(0, material.find('/')); }
  double lead_s() const { return imminent_s ? fall_s - *imminent_s : 0; }
  bool warned() const { return imminent_s.has_value(); }
  /// Whether the truth is what the list expects: there is nothing to compare with otherwise.
  bool comparable() const { return lost == collapses; }
  /// The specimen came so near to an onset that these instruments cannot tell it from one.
  bool near_zero() const { return least_work <= work_error; }
};

/// What the seed chooses beside varied(): the stress level (× 0.5 to 2), instruments (as they are,
/// or noise and steps as of a logger of 12 bits), time between readings in shear (× 1/4 to 16, from
/// 0.1 to 60 s), air in the pores (of some seeds: saturation of 97.5 to 99 %), a rest or a
/// loop on the way (interruption.hpp).
lab::Programme varied_for_alarm(const Subject& subject, std::uint64_t seed,
                                Instruments& instruments);

/// A test that was run, and can be heard once more.
struct AlarmTest {
  AlarmTrial trial;  ///< with an alarm that knew of nothing
  lab::RecordHeader header;
  std::vector<lab::Reading> readings;
  std::optional<lab::Truth> truth;          ///< of one that lost sustainability
  std::optional<lab::EarlierTest> earlier;  ///< what it says to tests that come after it
};
AlarmTest run_alarm_test(const Subject& subject, std::uint64_t seed);

/// What its report says to tests that come after it, without the specimen's truth.
std::optional<lab::EarlierTest> as_recorded(const lab::RecordHeader& header,
                                            lab::TestSummary summary,
                                            const std::vector<lab::Forecast>& forecasts);

/// The same readings, told to an alarm that knows of earlier tests; `also` listens.
AlarmTrial heard_again(const AlarmTest& test, const lab::EarlierTests& earlier,
                       const lab::SessionListeners& also = {});

}  // namespace triax::bench
