// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/onset_interval.hpp"

#include <algorithm>
#include <cmath>

#include "lab/collapse/onset_fit.hpp"

namespace triax::lab {
namespace {

constexpr double kAroundState = 12;  ///< readings on each side that give a state
constexpr std::size_t kLeastForCubic = 8;
constexpr int kStretch = 4;  ///< parts of the stretch between whose ends states are taken

/// Between the two samples around a reading, or at the last one on that side.
std::pair<double, double> read_at(const std::vector<PathSample>& samples, double reading) {
  const auto of = [](const PathSample& s) {
    return std::pair(s.signal[PathSample::q], s.signal[PathSample::p_eff]);
  };
  const auto after = std::ranges::find_if(
      samples, [=](const PathSample& s) { return s.signal[PathSample::reading] >= reading; });
  if (after == samples.begin()) return of(*after);
  if (after == samples.end()) return of(samples.back());
  const auto [qa, pa] = of(*(after - 1));
  const auto [qb, pb] = of(*after);
  const double first = (after - 1)->signal[PathSample::reading];
  const double share = (reading - first) / (after->signal[PathSample::reading] - first);
  return {std::lerp(qa, qb, share), std::lerp(pa, pb, share)};
}

/// Over single readings: those in between and, at both ends, what lies between two of them.
StressInterval over_readings(const std::vector<PathSample>& samples, const PathPoint& onset,
                             double low, double high) {
  StressSpan span(onset.q, onset.p_eff);
  for (const double end : {low, high}) {
    const auto [q, p] = read_at(samples, end);
    span.reach(q, p);
  }
  for (const PathSample& s : samples)
    if (s.signal[PathSample::reading] > low && s.signal[PathSample::reading] < high)
      span.reach(s.signal[PathSample::q], s.signal[PathSample::p_eff]);
  return span.interval(error_of_readings(onset.stress_variance, onset.q, onset.p_eff));
}

}  // namespace

PathPoint peak_of_readings(PathPoint onset, const PathHistory& history) {
  if (!onset.shortest_window()) return onset;
  const auto three = history.between(onset.reading - 1.5, onset.reading + 1.5);
  if (three.size() != 3) return onset;
  const auto bend = [&](PathSample::Signal signal) {
    return three[0].signal[signal] - 2 * three[1].signal[signal] + three[2].signal[signal];
  };
  const auto slope = [&](PathSample::Signal signal) {
    return (three[2].signal[signal] - three[0].signal[signal]) / 2;
  };
  const double sense = std::copysign(1.0, onset.q);
  if (!(sense * bend(PathSample::q) < 0)) return onset;
  const double x = -slope(PathSample::q) / bend(PathSample::q);
  if (std::fabs(x) > 1) return onset;
  const auto at = [&](PathSample::Signal signal) {
    return three[1].signal[signal] + x * (slope(signal) + x / 2 * bend(signal));
  };
  onset.reading = at(PathSample::reading);
  onset.progress = at(PathSample::progress);
  onset.q = at(PathSample::q);
  onset.p_eff = at(PathSample::p_eff);
  onset.axial_strain = at(PathSample::axial_strain);
  onset.volumetric_strain = at(PathSample::volumetric_strain);
  onset.pore_pressure = at(PathSample::pore_pressure);
  return onset;
}

std::optional<StressInterval> interval_over(const PathHistory& history, const PathPoint& onset,
                                            double low, double high, bool single) {
  low = std::clamp(low, history.first_reading(), history.last_reading());
  high = std::clamp(high, low, history.last_reading());
  if (single) {
    const auto samples = history.between(std::floor(low), std::ceil(high));
    if (samples.empty()) return std::nullopt;
    return over_readings(samples, onset, low, high);
  }
  StressSpan span(onset.q, onset.p_eff);
  const double length = history.last_reading() - history.first_reading();
  const auto fit_at = [&](double reading) -> std::optional<StressFit> {
    // Long ago the path is known in blocks of many readings.
    for (double reach = kAroundState; reach < 2 * kAroundState + length; reach *= 2) {
      const auto blocks = history.between(reading - reach, reading + reach);
      if (blocks.size() >= kLeastForCubic) return stress_at(blocks, reading);
    }
    return std::nullopt;
  };
  const auto here = fit_at(std::clamp(onset.reading, low, high));
  if (!here) return std::nullopt;
  for (int i = 0; i <= kStretch; ++i)
    if (const auto fit = fit_at(std::lerp(low, high, static_cast<double>(i) / kStretch)))
      span.reach(fit->q, fit->p_eff);
  return span.interval(here->error);
}

}  // namespace triax::lab
