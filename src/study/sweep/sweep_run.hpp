// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "db/recording/patience.hpp"
#include "lab/programmes/sweep.hpp"
#include "lab/results/summary.hpp"

namespace triax::study {

/// What one test of a sweep came to.
struct SweepMember {
  std::int64_t place = 0;          ///< from 1
  std::optional<std::int64_t> id;  ///< in the database; empty: not run, or taken out again
  std::string failure;             ///< why it failed; empty if it did not
  bool judged = false;
  lab::CollapseKind kind = lab::CollapseKind::none;
  std::optional<double> time_s, eta;  ///< at the onset found
  bool truly_lost = false;            ///< of the specimen itself, as the next two
  std::optional<double> true_time_s, true_eta;
};

struct SweepJob {
  std::string file;                       ///< of the programme
  std::string text;                       ///< what it holds
  std::vector<lab::TomlEdit> edits = {};  ///< the same for all tests
  const lab::Sweep& sweep;
  std::string name;  ///< of the sweep, for the database
  std::string db;
  double speed = 0;  ///< as SessionOptions
  int jobs = 1;      ///< tests that run at a time
  db::Patience patience = {};
};

/// What is put into the programme for the test at `place`: the sweep's values behind those that all
/// tests have. Throws lab::BadInput where both name a key.
std::vector<lab::TomlEdit> edits_of_member(const std::vector<lab::TomlEdit>& all,
                                           const lab::Sweep& sweep, std::int64_t place);

struct SweepCounts {
  std::int64_t done = 0;  ///< of them some failed
  std::int64_t failed = 0;
};

/// Runs every test of a sweep into the database. Memory is that of `jobs` tests and a few numbers
/// for each one that is over; results, their order and the order of ids do not depend on `jobs`. A
/// test that fails says why in its member and the others go on. Once `stop` is true no test is
/// started, and those under way are taken out of the database again. `show` is called about ten
/// times a second, as `stop` in this thread or, `stop` only, in others. Throws what befalls the
/// whole: no threads.
std::vector<SweepMember> run_sweep(const SweepJob& job, const std::function<bool()>& stop,
                                   const std::function<void(const SweepCounts&)>& show);

}  // namespace triax::study
