// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

#include "src/study/sweep/sweep_run.hpp"

namespace triax::src {

/// How far a sweep is and how long it will take, on standard error; draws nothing unless that is a
/// terminal.
class SweepProgress {
 public:
  explicit SweepProgress(std::int64_t total);
  ~SweepProgress();  ///< wipes the line
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;
  void show(const study::SweepCounts& counts);

 private:
  std::int64_t total_;
  bool on_terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "57 of 200 tests, 2 failed, 1.2 min left"; what is left is unknown before the first is done.
std::string progress_text(const study::SweepCounts& counts, std::int64_t total, double elapsed_s);

}  // namespace triax::src
