// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One simulated test, judged by the monitor and by the naive methods, against the specimen's truth.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bench/detection/statistics.hpp"
#include "lab/programmes/programme.hpp"
#include "lab/rig/back_end.hpp"

namespace triax::bench {

/// A programme of the list with what is expected of it.
struct Subject {
  lab::Programme programme;
  bool collapses = false;
};

inline constexpr std::array<std::string_view, 4> kMethods = {
    "triax", "maximum of q", "sign of neighbouring increments", "sign over moving average of 50"};

/// Which test a trial ran, and what is expected of it.
struct TrialHeader {
  std::string programme, type, material;
  std::uint64_t seed = 0;
  bool collapses = false;  ///< expected

  void fill(const lab::Programme& of, bool expected_to_collapse, std::uint64_t its_seed);
};

struct TrialResult : TrialHeader {
  std::string trait;  ///< name of its Kind; empty for a subject of the list
  std::int64_t readings = 0;
  bool truth_lost = false;  ///< what the specimen did
  double truth_time_s = 0, truth_eta = 0, truth_q_pa = 0, truth_p_pa = 0;
  std::optional<lab::StressInterval> interval;    ///< of the onset reported
  std::int64_t truth_reading = 0;                 ///< first reading at or after the true instant
  std::array<Outcome, kMethods.size()> outcomes;  ///< in the order of kMethods
  std::string kind;                               ///< the monitor's verdict

  /// False where a specimen that was to collapse did not: there is nothing to compare with.
  bool comparable() const { return truth_lost || !collapses; }
};

/// The subject's programme with everything varied that the seed chooses: instruments (noise × 0.5,
/// 1, 2 or 4; steps × 1 or 2), void ratio (± 0.01), consolidation stress (± 10 %, with the q of the
/// stages) and rates (× 0.5 to 2). Deterministic.
lab::Programme varied(const Subject& subject, std::uint64_t seed);

/// Uniform in [0, 1), from the seed and the number of the choice (splitmix64).
double choice(std::uint64_t seed, std::uint64_t number);

/// Runs it. Throws what rig and reduction throw.
TrialResult run_trial(const Subject& subject, std::uint64_t seed);
/// The same of a programme as it is, whose readings `rig` gives.
TrialResult judge_trial(const lab::Programme& programme, bool collapses, std::uint64_t seed,
                        lab::BackEnd& rig);

}  // namespace triax::bench
