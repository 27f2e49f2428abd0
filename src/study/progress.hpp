// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>

namespace triax::study {

/// Told what is under way ("probes") and how much of it is done, 0 to 1. May be empty.
using Progress = std::function<void(const std::string& what, double share)>;

/// Calls it where there is one.
inline void show(const Progress& progress, const std::string& what, double share) {
  if (progress) progress(what, share);
}

}  // namespace triax::study
