// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "lab/collapse/last_readings.hpp"
#include "lab/collapse/servo_search.hpp"
#include "lab/collapse/stress_span.hpp"

namespace triax::lab {
namespace {

using Signal = PathSample::Signal;
constexpr std::size_t kLeast = 8;
constexpr std::size_t kOfLast = 12;  ///< readings that give values and rates at the last one
constexpr std::size_t kOfModulus = 24;
constexpr double kNext = 1.5;  ///< readings ahead of the last, a mean over its interval
constexpr double kYields = 4;  ///< readings at held q before it falls

double ratio_of(const PathSample& s) { return s.signal[Signal::q] / s.signal[Signal::p_eff]; }

struct Estimate {
  double value = 0, error = 0;
};

/// η_c of the tangent modulus and k = −d(dq/dε₁)/dη, Pa.
struct Modulus {
  Estimate root;
  double k = 0;
};

/// Empty where the modulus does not fall as η grows.
std::optional<Modulus> root_of_modulus(std::span<const PathSample> samples) {
  const auto& first = samples.front().signal;
  const double scale = samples.back().signal[Signal::axial_strain] - first[Signal::axial_strain];
  std::vector<Eigen::Vector3d> terms;
  std::vector<double> y;
  double integral = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& s = samples[i].signal;
    if (i > 0)
      integral += (ratio_of(samples[i]) + ratio_of(samples[i - 1])) / 2 *
                  (s[Signal::axial_strain] - samples[i - 1].signal[Signal::axial_strain]) / scale;
    terms.emplace_back(1, (s[Signal::axial_strain] - first[Signal::axial_strain]) / scale,
                       integral);
    y.push_back(s[Signal::q] - first[Signal::q]);
  }
  const ThreeTerms fit(terms, y);
  const double slope = -fit.c[2];
  if (!(slope > 0)) return std::nullopt;
  const Eigen::Vector3d gradient(0, 1 / slope, fit.c[1] / (slope * slope));
  return Modulus{{fit.c[1] / slope, std::sqrt(gradient.dot(fit.covariance * gradient))},
                 slope / scale};
}

/// Of two ways of looking: what they differ by is an error of both.
Estimate both(const Estimate& a, const Estimate& b) {
  const double of_a = 1 / (a.error * a.error), of_b = 1 / (b.error * b.error);
  const double mean = (a.value * of_a + b.value * of_b) / (of_a + of_b);
  const double scatter = of_a * std::pow(a.value - mean, 2) + of_b * std::pow(b.value - mean, 2);
  return {mean, std::sqrt(std::max(1.0, scatter) / (of_a + of_b))};
}

/// All of the path near its last reading.
class Ending {
 public:
  explicit Ending(std::span<const PathSample> samples, std::size_t readings = kOfLast)
      : samples_(samples),
        readings_(readings),
        reading_(samples.back().signal[Signal::reading]),
        q_(at_last(samples, Signal::q, readings)),
        p_(at_last(samples, Signal::p_eff, readings)),
        ratio_(at_last(samples, ratio_of, readings)) {}

  const AtLast& ratio() const { return ratio_; }
  /// q where the ratio is η: on the way to the peak, or back along the readings.
  double q_at(double eta) const {
    const double ahead = (eta - ratio_.value) / ratio_.rate;
    return ahead > 0 ? q_.value + q_.rate * time_left(ahead) : q_.before(ahead);
  }
  PathPoint point_at(double eta) const;
  /// Until the fall, which the next reading shows.
  static double time_left(double ahead) { return std::min(ahead / 2, 1.0); }
  /// q at the next reading, had the specimen carried the load on.
  double q_next() const { return q_.value + q_.rate; }
  /// Of the parabola of q between two places.
  double largest_q(double first, double last) const {
    const double top = q_.bend != 0 ? -q_.rate / (2 * q_.bend) : first;
    return q_along(q_.value * q_.bend < 0 ? std::clamp(top, first, last) : last);
  }
  /// At held q: from where on the second-order work of the trend is smaller than that of a search
  /// as large as q scatters, see end_of_search(), before the volume turned.
  double start_of_search(const Turned& volume) const;
  double ratio_at(double readings) const { return ratio_.before(readings); }
  double q_along(double readings) const { return q_.before(readings); }
  StressError error_at(double readings) const {
    return {q_.error_at(readings), p_.error_at(readings), ratio_.error_at(readings)};
  }
  StressError error() const { return {q_.value_error, p_.value_error, ratio_.value_error}; }

 private:
  std::span<const PathSample> samples_;
  std::size_t readings_;
  double reading_;
  AtLast q_, p_, ratio_;
};

double Ending::start_of_search(const Turned& volume) const {
  const AtLast strain = at_last(samples_, Signal::volumetric_strain, readings_);
  const double of_search = kSwelling * work_of_search(q_.scatter, p_.value);
  double x = volume.first;
  const double first = 1 - static_cast<double>(readings_);
  while (x > first && std::fabs(p_.rate_at(x) * strain.rate_at(x)) < of_search) --x;
  return std::max(x, first);
}

PathPoint Ending::point_at(double eta) const {
  const double ahead = ratio_.rate != 0 ? (eta - ratio_.value) / ratio_.rate : 0;
  const auto along = [&](Signal signal, double readings) {
    const AtLast at = at_last(samples_, signal, readings_);
    return readings > 0 ? at.value + at.rate * readings : at.before(readings);
  };
  const double time = ahead > 0 ? time_left(ahead) : ahead;
  PathPoint p;
  p.reading = reading_ + std::min(std::round(time), 0.0);
  p.progress = along(Signal::progress, time);
  p.q = q_at(eta);
  p.p_eff = p.q / eta;
  p.axial_strain = along(Signal::axial_strain, ahead);
  p.volumetric_strain = along(Signal::volumetric_strain, ahead);
  p.pore_pressure = along(Signal::pore_pressure, ahead);
  return p;
}

/// The specimen yields by itself before it falls.
FallFit at_held_q(std::span<const PathSample> all) {
  const auto samples = all.last(std::min(all.size(), kOfModulus));
  const Ending ending(samples);
  const Turned volume = may_have_turned(all, Signal::volumetric_strain);
  FallFit fit;
  fit.point = ending.point_at(ending.ratio().value);
  StressSpan span(fit.point.q, fit.point.p_eff);
  for (const double readings : {-kYields, kNext})
    span.reach(fit.point.q, fit.point.q / ending.ratio_at(readings));
  if (volume.anywhere()) {
    const Ending longer(all, volume.of);
    span.reach(fit.point.q, fit.point.q / longer.ratio_at(longer.start_of_search(volume)));
  }
  const double last = ratio_of(samples.back());
  const double pace = last - ratio_of(samples[samples.size() - 2]);
  if (pace * ending.ratio().rate > 0) span.reach(fit.point.q, fit.point.q / (last + kNext * pace));
  fit.interval = span.interval(ending.error_at(kNext));
  return fit;
}

/// A spring let q pass its peak.
FallFit after_peak(const Ending& ending, const Turned& turned,
                   const std::optional<Modulus>& modulus) {
  const auto [least, most] =
      std::minmax({ending.ratio_at(turned.first), ending.ratio_at(turned.last)});
  const double middle = ending.ratio_at((turned.first + turned.last) / 2);
  const double eta = std::clamp(modulus ? modulus->root.value : middle, least, most);
  FallFit fit;
  fit.point = ending.point_at(eta);
  StressSpan span(fit.point.q, fit.point.p_eff);
  for (const double there : {turned.first, turned.last})
    span.reach(ending.q_along(there), ending.q_along(there) / ending.ratio_at(there));
  span.reach_q(ending.largest_q(turned.first, turned.last));
  fit.interval = span.interval(ending.error());
  return fit;
}

Estimate peak_under_load(const Ending& ending, const std::optional<Modulus>& modulus) {
  const AtLast& ratio = ending.ratio();
  const Estimate eta{ratio.value + ratio.rate,
                     std::hypot(ratio.rate / std::sqrt(3.0), ratio.value_error, ratio.rate_error)};
  return modulus ? both(modulus->root, eta) : eta;
}

/// The load carried the specimen over its peak within the next interval.
FallFit under_load(const Ending& ending, const Estimate& eta) {
  FallFit fit;
  fit.point = ending.point_at(eta.value);
  StressSpan span(fit.point.q, fit.point.p_eff);
  for (const double end : {-1.0, 1.0}) {
    const double there = eta.value + end * StressSpan::kOf95 * eta.error;
    span.reach(ending.q_at(there), ending.q_at(there) / there);
  }
  for (const double q : {ending.q_along(0), ending.q_next()}) span.reach(q, q / eta.value);
  fit.interval = span.interval(ending.error());
  return fit;
}

/// The state where the ratio was η for the last time, of means of five readings.
PathSample state_before(std::span<const PathSample> all, double eta) {
  constexpr std::size_t kAround = 2;
  PathSample mean;
  for (std::size_t i = all.size() - 1 - kAround;; --i) {
    mean = {};
    for (std::size_t j = i - kAround; j <= i + kAround; ++j)
      for (std::size_t k = 0; k < PathSample::kSignals; ++k)
        mean.signal[k] += all[j].signal[k] / (2 * kAround + 1);
    if (std::fabs(ratio_of(mean)) <= std::fabs(eta) || i == kAround) return mean;
  }
}

/// Where the pore fluid is compressed, from the fit of the peak of q with its ratio η_c.
void move_before_peak(std::span<const PathSample> all, const Ending& ending,
                      const FluidCompliance& c, double k, const Estimate& peak, FallFit& fit) {
  const auto samples = all.last(std::min(all.size(), kOfLast));
  const double strain = at_last(samples, Signal::axial_strain, kOfLast).rate;
  const AtLast u = at_last(samples, Signal::pore_pressure, kOfLast);
  const double p_rate = at_last(samples, Signal::p_eff, kOfLast).rate;
  const double earlier = -c.at(u.value) * u.rate * p_rate / (strain * strain) / k;
  const double last = ratio_of(all.back());
  if (!std::isfinite(earlier) || !(earlier * last > 0)) return;
  StressSpan span(fit.point.q, fit.point.p_eff);
  const double wide = std::copysign(StressSpan::kOf95 * peak.error, last);
  const auto is_before = [&](double eta) { return std::fabs(eta) < std::fabs(last); };
  const double eta = peak.value - earlier;
  if (is_before(eta)) {
    fit.point.middle = state_before(all, eta);
    fit.point = unsmoothed(fit.point);
    fit.point.reading = std::round(fit.point.reading);
    span = StressSpan(fit.point.q, fit.point.p_eff);
  } else if (std::fabs(eta) < std::fabs(fit.point.eta())) {
    fit.point = ending.point_at(eta);
    span = StressSpan(fit.point.q, fit.point.p_eff);
  }
  for (const double there :
       {peak.value - c.most * earlier - wide, peak.value - c.least * earlier + wide})
    if (is_before(there)) {
      const PathSample at = state_before(all, there);
      span.reach(at.signal[Signal::q], at.signal[Signal::p_eff]);
    }
  const StressInterval own = span.interval({});
  fit.interval = is_before(peak.value - c.least * earlier + wide) ? own : hull(own, fit.interval);
}

}  // namespace

std::optional<FallFit> fit_fall(std::span<const PathSample> all, bool held_q, double rate_of_stage,
                                const std::optional<FluidCompliance>& compliance) {
  if (all.size() < kLeast) return std::nullopt;
  const auto samples = all.last(std::min(all.size(), kOfModulus));
  const Ending ending(samples);
  const AtLast& ratio = ending.ratio();
  if (held_q) return at_held_q(all);
  const double sense = std::copysign(1.0, ratio.value);
  if (!(sense * ratio.rate > 0)) return std::nullopt;
  const auto modulus = root_of_modulus(samples);
  const Estimate peak = peak_under_load(ending, modulus);
  FallFit fit = under_load(ending, peak);
  if (!grows_steadily(all, rate_of_stage)) {
    const Turned turned = may_have_turned(samples, Signal::q);
    if (turned.anywhere()) {
      const StressInterval within = fit.interval;
      fit = after_peak(Ending(samples, turned.of), turned, modulus);
      if (turned.last >= 1) fit.interval = hull(fit.interval, within);
    }
  }
  if (compliance && modulus) move_before_peak(all, ending, *compliance, modulus->k, peak, fit);
  return fit;
}

}  // namespace triax::lab
