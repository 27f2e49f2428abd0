// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/results/summary.hpp"

namespace triax::lab {

/// What a criterion found: where, and the sentence that proves it.
struct Finding {
  Instant instant;
  std::string evidence;
  bool detected = true;  ///< false: it was looked at, and is no collapse
  /// When that was known; empty: only when the record had ended.
  std::optional<Moment> noticed{};
};

}  // namespace triax::lab
