// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/onset_interval.hpp"

#include <algorithm>
#include <cmath>

#include "lab/collapse/onset_fit.hpp"

namespace triax::lab {
namespace {

constexpr double kAroundState = 12;  ///< readings on each side that give a state
constexpr std::size_t kLeastForCubic = 8;
constexpr double kOfWindow = 3;  ///< readings of the shortest window before its middle
constexpr int kStretch = 4;      ///< parts of the stretch between whose ends states are taken

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

/// The most that a concave |q| may have been between two readings, from the two before and the two
/// after: where the lines through them meet. Steps need not be equal.
double crossing(const std::vector<PathSample>& samples, std::size_t first) {
  const auto at = [&](std::size_t i) {
    return std::pair(samples[i].signal[PathSample::reading], samples[i].signal[PathSample::q]);
  };
  const auto [x0, q0] = at(first);
  const auto [x1, q1] = at(first + 1);
  double q = std::fabs(q0) > std::fabs(q1) ? q0 : q1;
  const double sense = std::copysign(1.0, q);
  const double length = x1 - x0;
  std::optional<double> rise, fall;  // of |q|, along the line before and the line after
  if (first > 0) rise = sense * (q0 - at(first - 1).second) / (x0 - at(first - 1).first);
  if (first + 2 < samples.size())
    fall = sense * (q1 - at(first + 2).second) / (at(first + 2).first - x1);
  if (!rise || !(*rise > 0)) return q;
  if (!fall) return sense * std::max(std::fabs(q), std::fabs(q0) + *rise * length);
  if (!(*rise + *fall > 0)) return q;
  const double x = (std::fabs(q1) - std::fabs(q0) + *fall * length) / (*rise + *fall);
  if (!(x > 0 && x < length)) return q;
  return sense * (std::fabs(q0) + *rise * x);
}

/// The reading before that of the largest |q|: what falls from there on may have turned there.
double before_largest(const std::vector<PathSample>& samples) {
  const auto largest = std::ranges::max_element(
      samples, {}, [](const PathSample& s) { return std::fabs(s.signal[PathSample::q]); });
  return (largest == samples.begin() ? largest : largest - 1)->signal[PathSample::reading];
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
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    if (samples[i].signal[PathSample::reading] >= low &&
        samples[i + 1].signal[PathSample::reading] <= high)
      span.reach_q(crossing(samples, i));
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

std::optional<StressFit> stress_near(const PathHistory& history, double reading, double last) {
  const double length = history.last_reading() - history.first_reading();
  for (double r = kAroundState; r < 2 * kAroundState + length; r *= 2) {  // NOLINT: lengths
    const auto blocks = history.between(reading - r, std::min(reading + r, last));
    if (blocks.size() >= kLeastForCubic) return stress_at(blocks, reading);
  }
  return std::nullopt;
}

std::optional<StressInterval> interval_over(const PathHistory& history, const PathPoint& onset,
                                            const Stretch& stretch, bool single) {
  const double last = std::min(history.last_reading(), stretch.until);
  const double low = std::clamp(stretch.low, history.first_reading(), last);
  const double high = std::clamp(stretch.high, low, last);
  if (single) {
    const auto samples = history.between(std::floor(low) - kOfWindow, std::ceil(high) + 1);
    if (samples.empty()) return std::nullopt;
    return over_readings(samples, onset, std::min(low, before_largest(samples)), high);
  }
  StressSpan span(onset.q, onset.p_eff);
  const auto here = stress_near(history, std::clamp(onset.reading, low, high), last);
  if (!here) return std::nullopt;
  for (int i = 0; i <= kStretch; ++i)
    if (const auto fit =
            stress_near(history, std::lerp(low, high, static_cast<double>(i) / kStretch), last))
      span.reach(fit->q, fit->p_eff);
  return span.interval(here->error);
}

std::optional<StressInterval> interval_of_fit(const PathHistory& history, const OnsetFit& fit,
                                              const PathPoint& onset, double last) {
  const double within = StressSpan::kOf95 * fit.error;
  return interval_over(history, onset,
                       {fit.point.reading - within, fit.point.reading + within, last}, false);
}

void reach(Instant& onset, const Instant& other) {
  const auto of = [](const Instant& at) {
    return at.interval ? *at.interval : as_interval(*at.q_pa, *at.p_eff_pa);
  };
  onset.interval = hull(of(onset), of(other));
}

}  // namespace triax::lab
