// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How near a specimen is to its onset while the test runs, in constant memory and from readings
// alone.
#include <optional>

#include "lab/results/forecast.hpp"
#include "lab/results/state.hpp"
#include "lab/warning/onset_forecast.hpp"

namespace triax::lab {

/// Watches the driven path and says `approaching`, `imminent` and, where somebody else found it,
/// `lost`; a level is left in one way only, by clear evidence, and lost is never left within its
/// stage. The limits are in warning_limits.hpp.
///
///   approaching  little of η is left by the forecast and second-order work is low: along a strain
///   path
///                normalised, d²W/(|dσ′||dε|), while p′ falls on; at held q dy/dx over its largest.
///                Three looks in a row.
///   imminent     along a strain path: normalised work lower still; by displacement also that the
///                forecast may be passed (a standard error before it). At held q: at the present
///                rate the onset may be kScans scans away, or kSeconds or a share of the stage,
///                whichever is less; or normalised work is so low that a hunting pressure may bring
///                the fall. Two looks in a row, one where the stage has few and the next comes
///                late.
///   none         what the specimen answers grows for certain and the onset is far, or none, at
///                five looks in a row
///
/// A look without a forecast that shows nothing for certain counts for neither.
/// Neither level where the onset forecast lies on the limit surface, nor, where no limit is known,
/// above η = 1, which no loose sand reaches before it is lost.
class WarningLevels {
 public:
  explicit WarningLevels(bool has_time, const EarlierTests& earlier = {})
      : has_time_(has_time), forecast_(earlier) {}

  void start_stage(const StageInfo* stage, const SpecimenVolume& volume = {});
  /// What was measured so far says nothing of the stage that starts next.
  void forget() { forecast_.forget(); }
  /// The next state in shear; true where the forecast was made anew. Pre-condition:
  /// complete(state).
  bool add(const State& state);
  /// After add(); `inside` says whether the onset that forecast() names lies inside the limit
  /// surface (empty: unknown). True where the level changed.
  /// `below_limit`: by how much of the limit's η that one lies below it; 1 where nobody gave one.
  bool look(std::optional<bool> inside, double below_limit = 1);
  /// It was lost, as a criterion found. True where that is news.
  bool lose();

  WarningLevel level() const { return level_; }
  /// η to come, with its sign; empty where there is no forecast that says anything.
  std::optional<double> eta_forecast() const;
  /// The forecast as it stands at that reading.
  std::optional<Forecast> current_forecast(const State& now) const;

 private:
  const std::optional<EtaForecast>& forecast() const { return forecast_.now(); }
  bool is_far() const;
  double count_look(bool shows, double in_row) const;
  bool is_near() const;
  bool is_imminent() const;
  bool is_imminent_on_path() const;
  bool is_imminent_at_held_q() const;
  bool carried_on_there() const;
  bool may_come() const;
  bool within_scans(double eta, double scans) const;
  double since(const State& s) const;
  bool is_last_chance() const;
  std::optional<LeftToOnset> left(double eta) const;

  bool has_time_;
  bool is_new_ = false;  ///< the forecast of the latest state
  OnsetForecast forecast_;
  std::optional<State> first_, before_, state_;
  double room_ = 1;                       ///< fraction of the limits of work that counts
  double eta_now_ = 0;                    ///< |η| of the latest states, the lower of two
  double eta_before_ = 0;                 ///< |η| of the one before
  double near_ = 0, far_ = 0, soon_ = 0;  ///< independent looks in a row
  WarningLevel level_ = WarningLevel::none;
};

}  // namespace triax::lab
