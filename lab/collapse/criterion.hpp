// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One way of telling from the measured path that a specimen collapsed. The list of them is
// criteria.cpp.
#include <optional>
#include <string>

#include "lab/measured/path_rates.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"
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

class CollapseCriterion {
 public:
  virtual ~CollapseCriterion() = default;

  /// Findings that are made from here on are known at that reading; empty: the record is over.
  void set_now(const std::optional<Moment>& now) { now_ = now; }
  /// A stage begins; null where the header does not know it.
  virtual void start_stage(const StageInfo* stage) = 0;
  /// Every complete state in shear.
  virtual void add_state(const State& /*state*/, bool /*has_time*/) {}
  /// Every point at which the rates of the path, and with them second-order work, are known.
  virtual void add_point(const PathPoint& /*point*/, bool /*has_time*/) {}
  /// What was found so far; it may still be sharpened.
  virtual std::optional<Finding> finding() const = 0;
  /// Why it could not have found anything: what it looks at is prescribed. Empty: it looked.
  virtual std::string blind() const { return {}; }

 protected:
  std::optional<Moment> now_;
  CollapseCriterion() = default;
  CollapseCriterion(const CollapseCriterion&) = default;
  CollapseCriterion& operator=(const CollapseCriterion&) = default;
};

}  // namespace triax::lab
