// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/placed_bursts.hpp"

#include <algorithm>

#include "lab/collapse/fall_fit.hpp"
#include "lab/collapse/onset_interval.hpp"
#include "lab/measured/instant.hpp"

namespace triax::lab {
namespace {

constexpr double kBeforeFall = 60;  ///< readings that place a fall
constexpr double kBeforeTurn = 64;  ///< and the turn of the volume before it

/// From the reading before it to the one after it.
std::optional<StressInterval> interval_of(const Finding& burst, const PathHistory& history,
                                          const std::optional<PathPoint>& near) {
  PathPoint at = near.value_or(PathPoint{});
  at.q = burst.instant.q_pa.value_or(kMissing);
  at.p_eff = burst.instant.p_eff_pa.value_or(kMissing);
  const auto reading = static_cast<double>(burst.instant.reading);
  return interval_over(history, at, {reading - 1, reading + 1}, true);
}

/// Few readings before the fall its turn is too weak to be sure of, but it may be the onset.
void reach_turn_of_volume(const PathHistory& history, double last, bool has_time, Instant& fall) {
  const auto turn = fit_onset(history.between(last - kBeforeTurn, last), Witness::volume, last);
  if (!turn) return;
  Instant at = instant_of(turn->point, has_time);
  at.interval = interval_of_fit(history, *turn, turn->point, last);
  reach(fall, at);
}

Instant fall_at(const Instant& burst, const std::optional<StressInterval>& interval,
                const PathHistory& history, const PlacedBursts::Stage& stage) {
  Instant fall = burst;
  fall.interval = interval;
  const auto last = static_cast<double>(burst.reading);
  const double rate_of_stage =
      (burst.q_pa.value_or(0) - stage.q) / std::max(last - history.first_reading(), 1.0);
  const auto fit = fit_fall(history.between(last - kBeforeFall, last), stage.held, rate_of_stage,
                            stage.compliance);
  if (fit) {
    fall = instant_of(fit->point, stage.has_time);
    fall.interval = fit->interval;
  }
  if (stage.held && stage.drained) reach_turn_of_volume(history, last, stage.has_time, fall);
  return fall;
}

}  // namespace

void PlacedBursts::place(const LossOfControl& control, const PathHistory& history,
                         const std::optional<PathPoint>& near, const Stage& stage) {
  const Finding& burst = *control.found();
  const auto& earlier = control.earlier();
  std::erase_if(placed_, [&](const PlacedBurst& one) {
    return !earlier || one.of != earlier->instant.reading;
  });
  PlacedBurst& one = placed_.emplace_back();
  one.of = burst.instant.reading;
  one.interval = interval_of(burst, history, near);
  if (!control.sudden()) return;
  one.fall = fall_at(burst.instant, one.interval, history, stage);
  Stage rigid = stage;
  rigid.compliance.reset();
  one.control = stage.compliance ? fall_at(burst.instant, one.interval, history, rigid) : one.fall;
  if (near) one.work = work_of_fall(control.fall()->before, control.fall()->after, *near);
}

const PlacedBurst* PlacedBursts::of(const Finding& burst) const {
  const auto found = std::ranges::find(placed_, burst.instant.reading, &PlacedBurst::of);
  return found == placed_.end() ? nullptr : &*found;
}

}  // namespace triax::lab
