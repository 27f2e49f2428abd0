// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the virtual specimen went through as no instrument sees it: its own loss of sustainability
// and its runaways. It drives nothing (decision 15).
#include <optional>
#include <string>

#include "lab/rig/simulated/run_away_log.hpp"
#include "lab/rig/simulated/truth_watch.hpp"

namespace triax::lab {

/// One step of the specimen.
struct TrueStep {
  double time_s = 0;  ///< at its start
  double dt_s = 0;
  const sim::SpecimenState& before;
  const sim::SpecimenStep& step;
  bool sheared = false;
  double height_at_shear_m = 0;
};

class TruthLog {
 public:
  /// Grains jump now and then: a self-driven law is watched over longer paths.
  explicit TruthLog(const sim::Specimen::MaterialLaw& law);

  /// Second-order work of every step that did not fail.
  void add_work(const TrueStep& one);
  /// Runaways of every step after which the test goes on. Returns a sentence where one began or
  /// ended in it, else nothing.
  std::string add_run_away(const TrueStep& one);

  /// Where the cap fell before second-order work turned, the specimen lost its equilibrium where
  /// that began; `last`: where the specimen is now.
  Truth truth(const sim::SpecimenState& last) const;

 private:
  TruthWatch watch_;
  RunAwayLog run_aways_;
  std::optional<Truth> lost_;  ///< where the last runaway began, if that was in shear
};

}  // namespace triax::lab
