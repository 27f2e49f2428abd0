// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/base/toml_reader.hpp"

namespace triax::src {

/// `triax simulate PROGRAMME --sweep ...`.
struct SweepOptions {
  std::string programme;
  std::vector<lab::TomlEdit> edits;  ///< of --set, the same for all tests
  std::vector<std::string> sweeps;   ///< KEY=VALUES each
  std::string db;
  double speed = 0;
  int jobs = 0;  ///< 0: as many as there are cores
  bool json = false;
};

/// Runs, stores and prints all tests of a sweep. Throws lab::BadInput for a sweep that makes no
/// sense before anything is stored; lab::WorkFailed once all is printed if some tests failed or
/// were not run.
void run_sweep_command(const SweepOptions& options);

}  // namespace triax::src
