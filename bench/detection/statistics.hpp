// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What many tests come to.
#include <cstdint>
#include <optional>
#include <vector>

namespace triax::bench {

/// The smallest of the values that at least `share` of them do not exceed (nearest rank, 0 < share
/// ≤ 1). Empty for no values.
std::optional<double> quantile(std::vector<double> values, double share);

/// One test by one method, held against the specimen's own truth.
struct Outcome {
  bool collapses = false;  ///< expected to: a test of a collapsing programme, not a control
  bool detected = false;
  std::optional<double> eta_error;    ///< |η at the onset reported − η at the true one|
  std::optional<std::int64_t> delay;  ///< see Summary
  /// The same of the reading at which it was said; empty where nothing was said while it ran.
  std::optional<std::int64_t> notice_delay;
};

struct Spread {
  std::optional<double> half, most, all;  ///< quantiles at 50 %, 95 % and 100 %
};

/// Delay = reading reported as onset − first reading at or after the true instant; its absolute
/// value is counted, too early is as wrong as too late.
struct Summary {
  int collapsing = 0, detected = 0;
  int unnoticed = 0;  ///< collapsing tests of which nothing was said while they ran
  int controls = 0, false_alarms = 0;
  Spread eta_error, delay, notice_delay;

  /// Shares; 1 and 0 where there is no such test.
  double detection() const;
  double false_alarm() const;
};

Summary summarise(const std::vector<Outcome>& outcomes);

}  // namespace triax::bench
