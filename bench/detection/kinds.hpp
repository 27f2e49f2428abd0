// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What makes an onset hard to place: cheap instruments, few readings, fast tests, records that end
// in the fall. The error of the onset and whether its interval covers the truth, kind by kind.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/detection/trial.hpp"

namespace triax::bench {

struct Kind {
  std::string_view name;       ///< several rows may make one kind
  std::string_view programme;  ///< file, from the root of the tree
  std::string_view material;   ///< that replaces its own; empty keeps it
  /// Changes the programme; `seed` chooses what is left open.
  void (*alter)(lab::Programme& programme, std::uint64_t seed);
  /// The record ends once a share of q is lost that the seed chooses, 3 to 60 %.
  bool ends_in_the_fall = false;
};
std::span<const Kind> kinds();

/// The test of that kind and seed, varied as any other (trial.hpp), then altered. What no
/// interval speaks of, the zero, scale and drift of instruments, is left out except in the kind
/// that is called after it.
TrialResult run_kind(const Kind& kind, std::uint64_t seed);

/// A line a kind: error of η, delay, how wide the interval is and how often it holds the truth.
std::string table_of_kinds(const std::vector<TrialResult>& results);

}  // namespace triax::bench
