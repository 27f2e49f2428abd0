// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/instrument_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace triax::lab {
namespace {

/// By how much `now` surely lies beyond `before`: 0 where they may be the same.
double moved_s(double before_least, double before_most, double now_least, double now_most) {
  if (now_least > before_most) return now_least - before_most;
  return now_most < before_least ? now_most - before_least : 0;
}

}  // namespace

void InstrumentClocks::take(const std::string& instrument, double stamp_s, double asked_s,
                            double answered_s) {
  const Offset now{stamp_s - answered_s, stamp_s - asked_s};
  const auto [found, is_new] = all_.try_emplace(instrument, Clock{now, now, asked_s, 0});
  if (is_new) return;
  Clock& clock = found->second;
  const Offset before = std::exchange(clock.last, now);
  const double step_s = moved_s(before.least_s, before.most_s, now.least_s, now.most_s);
  if (std::fabs(step_s) > tolerance_s_) {
    news_.push_back(
        fmt::format("{} clock jumped by {:+.1f} s; readings use the time of this computer",
                    instrument, step_s));
    clock = {now, now, asked_s, 0};
    return;
  }
  const double drift_s = moved_s(clock.start.least_s, clock.start.most_s, now.least_s, now.most_s);
  // Each doubling once: a clock that is slow for days is not told every second.
  if (std::fabs(drift_s) < std::max(tolerance_s_, 2 * clock.told_s)) return;
  clock.told_s = std::fabs(drift_s);
  news_.push_back(
      fmt::format("{} clock runs {}: {:.1f} s {} after {:.0f} s ({:+.2g} %); readings use the time "
                  "of this computer",
                  instrument, drift_s > 0 ? "fast" : "slow", std::fabs(drift_s),
                  drift_s > 0 ? "ahead" : "behind", answered_s - clock.start_s,
                  100 * drift_s / (answered_s - clock.start_s)));
}

}  // namespace triax::lab
