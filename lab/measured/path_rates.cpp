// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/path_rates.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

using Signal = PathSample::Signal;

/// Error of a second-order work of which nothing is known: the whole range [−1, 1].
constexpr double kUnknown = 2;
/// From here on a window of four times the length would not resolve the work either.
constexpr double kHopeless = 0.5;
constexpr std::int64_t kLongStage = 1024;  // readings

/// Variances of the stress and the strain vector, from those of their components:
/// S² = 3p² + ⅔q² and E² = ⅓ε_v² + 3/2 ε_q², ε_q = ε₁ − ε_v/3.
struct VectorVariance {
  double stress, strain;
  explicit VectorVariance(const LocalFit::Values& variance)
      : stress(3 * variance[Signal::p_eff] + variance[Signal::q] * 2 / 3),
        strain(variance[Signal::volumetric_strain] / 3 +
               1.5 * (variance[Signal::axial_strain] + variance[Signal::volumetric_strain] / 9)) {}
};

}  // namespace

PathPoint unsmoothed(PathPoint p) {
  const auto& s = p.middle.signal;
  p.reading = s[Signal::reading];
  p.progress = s[Signal::progress];
  p.q = s[Signal::q];
  p.p_eff = s[Signal::p_eff];
  p.axial_strain = s[Signal::axial_strain];
  p.volumetric_strain = s[Signal::volumetric_strain];
  p.pore_pressure = s[Signal::pore_pressure];
  return p;
}

double direction_error(const PathStep& step, double stress_variance, double strain_variance) {
  const double shear = step.axial - step.volumetric / 3;
  const double stress2 = 3 * step.p * step.p + step.q * step.q * 2 / 3;
  const double strain2 = step.volumetric * step.volumetric / 3 + 1.5 * shear * shear;
  if (!(stress2 > 0) || !(strain2 > 0)) return kUnknown;
  return std::min(std::sqrt(stress_variance / stress2 + strain_variance / strain2), kUnknown);
}

double normalised_second_order_work(const PathStep& step) {
  const sim::AxisymmetricStress stress{step.p + 2 * step.q / 3, step.p - step.q / 3};
  const sim::AxisymmetricStrain strain{step.axial, (step.volumetric - step.axial) / 2};
  return sim::second_order_work({}, stress, strain).normalised;
}

void PathRates::add(const PathSample& sample) {
  pyramid_.add(sample);
  for (int level = 0; level < pyramid_.closed_levels() && pyramid_.full(level); ++level) {
    if (levels_[level].rest-- > 0) continue;
    const LocalFit fit = fit_window(pyramid_, level);
    learn(fit, levels_[level]);
    const PathPoint point = point_at(fit, level, 0);
    levels_[level].error = point.normalised_error;
    // In a long stage windows too short for the noise are most of all: one in four tells when that
    // changes.
    const bool hopeless = point.normalised_error > kHopeless && pyramid_.samples() > kLongStage;
    levels_[level].rest = hopeless ? 3 : 0;
    if (!resolves(point, level)) continue;
    last_fit_ = fit;
    last_level_ = level;
    hand_on(point);
    return;
  }
}

bool PathRates::resolves(const PathPoint& point, int level) const {
  // A window longer than an eighth of the stage so far would blur the stage into one point.
  const bool longest = point.window_readings * 8 > pyramid_.samples();
  // Doubling the window against white noise cuts the error almost to a third; if it does not cut it
  // at all, curvature rules and the shorter window is the better one. Only where something is
  // resolved: two windows of pure noise are equally bad.
  const bool longer_is_worse = point.normalised_error < 5 * kTolerance &&
                               pyramid_.full(level + 1) &&
                               levels_[level + 1].error >= point.normalised_error;
  return point.normalised_error <= kTolerance || longest || longer_is_worse;
}

void PathRates::learn(const LocalFit& fit, Level& level) {
  const double weight = 1.0 / std::min(++level.fits, 12);
  for (std::size_t k = 0; k < PathSample::kSignals; ++k)
    level.noise[k] += weight * (fit.variance[k] - level.noise[k]);
}

PathPoint PathRates::point_at(const LocalFit& fit, int level, double offset) const {
  const auto value = [&](Signal k) {
    return fit.value[k] + offset * (fit.slope[k] + offset * fit.curvature[k]);
  };
  const auto slope = [&](Signal k) { return fit.slope[k] + 2 * offset * fit.curvature[k]; };
  // Where progress stands still (a strain that repeats itself) rates per block keep the direction.
  const double progress_slope = slope(Signal::progress);
  const double scale = progress_slope > 0 ? 1 / progress_slope : 1;

  PathPoint p;
  // Of the window itself its middle: where readings are missing the parabola through their numbers
  // gives two windows the same one.
  p.reading = offset == 0 ? fit.middle.signal[Signal::reading] : value(Signal::reading);
  p.progress = value(Signal::progress);
  p.q = value(Signal::q);
  p.p_eff = value(Signal::p_eff);
  p.axial_strain = value(Signal::axial_strain);
  p.volumetric_strain = value(Signal::volumetric_strain);
  p.pore_pressure = value(Signal::pore_pressure);
  p.q_rate = slope(Signal::q) * scale;
  p.p_rate = slope(Signal::p_eff) * scale;
  p.axial_rate = slope(Signal::axial_strain) * scale;
  p.volumetric_rate = slope(Signal::volumetric_strain) * scale;
  p.pore_rate = slope(Signal::pore_pressure) * scale;
  p.window_readings = std::int64_t{BlockPyramid::kBlocks} << level;
  p.middle = fit.middle;
  if (offset != 0)
    for (std::size_t k = 0; k < PathSample::kSignals; ++k)
      p.middle.signal[k] = value(static_cast<Signal>(k));

  const sim::StretchedState at{{p.p_eff + 2 * p.q / 3, p.p_eff - p.q / 3},
                               {p.axial_strain, (p.volumetric_strain - p.axial_strain) / 2}};
  p.work = sim::second_order_work(at, {p.p_rate + 2 * p.q_rate / 3, p.p_rate - p.q_rate / 3},
                                  {p.axial_rate, (p.volumetric_rate - p.axial_rate) / 2});

  // Variance of b + 2c i, where b and c are independent with 1/28 and 1/84 of a block's variance.
  const double factor = (LocalFit::kSlopeFactor + offset * offset / 21) * scale * scale;
  LocalFit::Values variance;
  for (std::size_t k = 0; k < PathSample::kSignals; ++k)
    variance[k] = factor * std::max(levels_[level].noise[k], fit.variance[k] * 0.25);
  const VectorVariance of_rates(variance);
  p.normalised_error = direction_error({p.q_rate, p.p_rate, p.axial_rate, p.volumetric_rate},
                                       of_rates.stress, of_rates.strain);
  // A parabola's value at the centre has 1/3 of a block's variance, its slope 1/28.
  const double to_value = (1.0 / 3) / (LocalFit::kSlopeFactor * scale * scale);
  p.stress_variance = of_rates.stress * to_value;
  p.strain_variance = of_rates.strain * to_value;
  p.q_rate_error = std::sqrt(variance[Signal::q]);
  p.p_rate_error = std::sqrt(variance[Signal::p_eff]);
  p.axial_rate_error = std::sqrt(variance[Signal::axial_strain]);
  p.volumetric_rate_error = std::sqrt(variance[Signal::volumetric_strain]);
  p.pore_rate_error = std::sqrt(variance[Signal::pore_pressure]);
  return p;
}

void PathRates::hand_on(const PathPoint& point) {
  if (std::llround(point.reading) <= std::llround(last_reading_)) return;
  last_reading_ = point.reading;
  if (on_point) on_point(point);
}

void PathRates::finish() {
  if (last_level_ >= 0)
    for (int i = 1; i <= BlockPyramid::kBlocks / 2; ++i)
      hand_on(point_at(last_fit_, last_level_, i));
  pyramid_.clear();
  levels_ = {};
  last_level_ = -1;
}

}  // namespace triax::lab
