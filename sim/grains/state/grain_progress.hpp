// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a long piece of work with grains tells while it runs, and how it is stopped.
#include <functional>
#include <string>

namespace triax::sim {

/// Called now and then with the share done, 0 to 1 (never falling within one piece of work), and
/// what is being done. Returning false stops the work at the next occasion; its result says so. May
/// be empty. Where work runs on several threads it is called by one of them at a time.
using GrainProgress = std::function<bool(double done, const std::string& what)>;

inline bool goes_on(const GrainProgress& progress, double done, const std::string& what) {
  return !progress || progress(done, what);
}

}  // namespace triax::sim
