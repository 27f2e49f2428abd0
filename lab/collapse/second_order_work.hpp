// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Second-order work of the measured path turns negative, and strength is lost with it; under a held
// q, which does not fall, the specimen yields instead.
#include <optional>

#include "lab/collapse/criterion.hpp"
#include "lab/collapse/descent.hpp"

namespace triax::lab {

/// Where it began, with the interval of its stresses.
Instant onset_of(const Descent& descent, bool has_time);

/// A descent under a held q shows in the strain, not in q: it counts once the axial strain has
/// grown by 1 % since the onset without second-order work turning positive again.
bool lasts_at_held_q(const Descent& descent);

class SecondOrderWork : public CollapseCriterion {
 public:
  void start_stage(const StageInfo* stage) override;
  void add_point(const PathPoint& point, bool has_time) override;
  /// The descent at held q, if any lasted, else the worst; detected where it lasted, or cost
  /// assessment_limits::kLossOfStrength.
  std::optional<Finding> finding() const override;

  const std::optional<Descent>& latest() const { return descents_.latest(); }
  const std::optional<Descent>& worst() const { return descents_.worst(); }
  /// The first that lasted while q was held, as it stands now.
  const std::optional<Descent>& at_held_q() const;
  /// Whether the latest, as it stands now, is a loss of sustainability.
  bool latest_counts() const;
  /// Gives the latest descent a sharper onset.
  void sharpen(const PathPoint& onset, const std::optional<StressInterval>& interval) {
    descents_.sharpen(onset, interval);
  }

 private:
  DescentTracker descents_;
  std::optional<Descent> held_;
  bool held_q_ = false;                    ///< in the stage under way
  Drainage drainage_ = Drainage::unknown;  ///< likewise
  bool has_time_ = true;
};

}  // namespace triax::lab
