// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/restart_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace triax::lab {

RestartFinder::Candidate::Candidate() = default;

RestartFinder::Track::Track() : first(std::numeric_limits<double>::quiet_NaN()), last(first) {}

/// A value that is missing or has not moved has not returned.
bool RestartFinder::Track::is_returned(double now) const {
  return largest > 0 && std::fabs(now - first) <= kReturned_fraction * largest;
}

/// The same, or nearer to zero, of either sign: a test may lack its first readings.
bool RestartFinder::Track::is_unloaded(double now) const {
  return is_returned(now) || (largest > 0 && std::fabs(now) <= std::fabs(first));
}

/// The first steps of a test are no measure of its steps.
bool RestartFinder::Track::jumps(double now) const {
  constexpr int kMin_steps = 4;
  return steps >= kMin_steps && largest_step > 0 &&
         std::fabs(now - last) > kJump_steps * largest_step * rows_since_last;
}

void RestartFinder::Track::add(double now, bool begins_new_stage) {
  if (std::isnan(now)) return skip();
  if (std::isnan(first)) first = last = now;
  if (!begins_new_stage) {
    largest_step = std::max(largest_step, std::fabs(now - last) / rows_since_last);
    ++steps;
  }
  rows_since_last = 1;
  largest = std::max(largest, std::fabs(now - first));
  last = now;
}

std::optional<Restart> RestartFinder::add(const RowState& now, std::int64_t line,
                                          bool begins_new_stage) {
  using enum RowValue;
  std::optional<Restart> found;
  const std::int64_t reading = readings_++;
  if (std::isnan(now[index(strain)])) {
    for (Track& track : tracks_) track.skip();
    return found;
  }
  if (candidate_) {
    found = follow(now);
  } else if (!begins_new_stage && is_back_at_start(now)) {
    candidate_.emplace();
    Restart& restart = candidate_->restart;
    restart.first = now;
    restart.line_before = last_line_;
    restart.line = line;
    restart.reading = reading;
    for (std::size_t i = 0; i < kRowValueCount; ++i) restart.before[i] = tracks_[i].last;
    continue_test(candidate_->tracks, now, false);
  } else {
    continue_test(tracks_, now, begins_new_stage);
  }
  last_line_ = line;
  return found;
}

bool RestartFinder::is_back_at_start(const RowState& now) const {
  using enum RowValue;
  const auto is_returned = [&](RowValue value) {
    return track(value).is_returned(now[index(value)]);
  };
  const auto jumps = [&](RowValue value) { return track(value).jumps(now[index(value)]); };
  if (!track(strain).is_unloaded(now[index(strain)])) return false;
  const bool is_time_back = now[index(time)] < track(time).last;
  const bool loaded_as_first =
      track(load).is_unloaded(now[index(load)]) && track(load).largest > track(load).largest_step;
  if (jumps(strain) && (is_time_back || loaded_as_first)) return true;
  if (!loaded_as_first) return false;
  return (is_time_back && is_returned(time)) ||
         (is_returned(pressure) && (jumps(pressure) || jumps(load) || jumps(cycle)));
}

void RestartFinder::continue_test(Tracks& tracks, const RowState& now, bool begins_new_stage) {
  for (std::size_t i = 0; i < kRowValueCount; ++i) tracks[i].add(now[i], begins_new_stage);
}

/// A row after the one that may begin another test.
std::optional<Restart> RestartFinder::follow(const RowState& now) {
  using enum RowValue;
  constexpr int kRows = 3;
  Candidate& candidate = *candidate_;
  const Restart& restart = candidate.restart;
  const Track& of_strain = track(strain);
  const double strain_now = now[index(strain)];
  const double last_strain = candidate.tracks[index(strain)].last;
  const bool is_near_end = std::fabs(strain_now - restart.before[index(strain)]) <
                           std::fabs(strain_now - restart.first[index(strain)]);
  const bool strain_jumps_back =
      is_near_end && std::fabs(strain_now - last_strain) > kJump_steps * of_strain.largest_step;
  const bool clock_goes_on =
      restart.is_time_back() && !(now[index(time)] < restart.before[index(time)]);
  if (strain_jumps_back || clock_goes_on) {
    candidate_.reset();
    continue_test(tracks_, now, false);
    return std::nullopt;
  }
  continue_test(candidate.tracks, now, false);
  ++candidate.rows;
  const bool moves_on = restart.is_time_back()
                            ? now[index(time)] > restart.first[index(time)]
                            : candidate.rows >= kRows && !of_strain.is_unloaded(strain_now);
  if (!moves_on) return std::nullopt;
  const Restart found = restart;
  tracks_ = candidate.tracks;
  candidate_.reset();
  return found;
}

std::optional<Restart> RestartFinder::open() const {
  if (!candidate_) return std::nullopt;
  return candidate_->restart;
}

}  // namespace triax::lab
