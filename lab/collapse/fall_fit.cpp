// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/collapse/stress_span.hpp"

namespace triax::lab {
namespace {

using Signal = PathSample::Signal;
constexpr std::size_t kLeast = 8;
constexpr std::size_t kOfLast = 12;  ///< readings that give values and rates at the last one
constexpr double kYields = 4;        ///< readings at held q before it falls
constexpr double kPassed = 3;        ///< standard errors by which q has passed its peak

double ratio_of(const PathSample& s) { return s.signal[Signal::q] / s.signal[Signal::p_eff]; }

/// Least squares of y over three terms.
struct ThreeTerms {
  Eigen::Vector3d c = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  ThreeTerms(const std::vector<Eigen::Vector3d>& terms, const std::vector<double>& y) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < y.size(); ++i) {
      normal += terms[i] * terms[i].transpose();
      right += y[i] * terms[i];
    }
    const Eigen::Matrix3d inverse = normal.ldlt().solve(Eigen::Matrix3d::Identity());
    c = inverse * right;
    double square = 0;
    for (std::size_t i = 0; i < y.size(); ++i) square += std::pow(y[i] - c.dot(terms[i]), 2);
    covariance = inverse * (square / static_cast<double>(y.size() - 3));
  }
};

/// A quantity at the last reading, and its change from one reading to the next there.
struct AtLast {
  double value = 0, rate = 0, bend = 0, value_error = 0, rate_error = 0;
  /// Back along the readings.
  double before(double readings) const { return value + readings * (rate + readings * bend); }
};

template <class Value>
AtLast at_last(std::span<const PathSample> samples, const Value& value) {
  const auto newest = samples.last(std::min(samples.size(), kOfLast));
  const double last = newest.back().signal[Signal::reading], origin = value(newest.back());
  std::vector<Eigen::Vector3d> terms;
  std::vector<double> y;
  for (const PathSample& s : newest) {
    const double x = s.signal[Signal::reading] - last;
    terms.emplace_back(1, x, x * x);
    y.push_back(value(s) - origin);
  }
  const ThreeTerms fit(terms, y);
  return {origin + fit.c[0], fit.c[1], fit.c[2], std::sqrt(fit.covariance(0, 0)),
          std::sqrt(fit.covariance(1, 1))};
}

AtLast at_last(std::span<const PathSample> samples, Signal signal) {
  return at_last(samples, [signal](const PathSample& s) { return s.signal[signal]; });
}

struct Estimate {
  double value = 0, error = 0;
};

/// η_c of the tangent modulus; empty where that does not fall as η grows.
std::optional<Estimate> root_of_modulus(std::span<const PathSample> samples) {
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
  if (!(slope * scale > 0)) return std::nullopt;
  const Eigen::Vector3d gradient(0, 1 / slope, fit.c[1] / (slope * slope));
  return Estimate{fit.c[1] / slope, std::sqrt(gradient.dot(fit.covariance * gradient))};
}

/// η where a parabola of q over ε₁ has its vertex.
std::optional<Estimate> vertex_of_q(std::span<const PathSample> samples) {
  const double last = samples.back().signal[Signal::axial_strain];
  const double scale = last - samples.front().signal[Signal::axial_strain];
  std::vector<Eigen::Vector3d> terms;
  std::vector<double> q, ratio;
  for (const PathSample& s : samples) {
    const double x = (s.signal[Signal::axial_strain] - last) / scale;
    terms.emplace_back(1, x, x * x);
    q.push_back(s.signal[Signal::q] - samples.back().signal[Signal::q]);
    ratio.push_back(ratio_of(s));
  }
  const ThreeTerms of_q(terms, q), of_ratio(terms, ratio);
  const double bend = of_q.c[2], x = -of_q.c[1] / (2 * bend);
  if (!(samples.back().signal[Signal::q] * bend < 0) || !(x > -1 && x < 1)) return std::nullopt;
  const Eigen::Vector3d gradient(0, -1 / (2 * bend), of_q.c[1] / (2 * bend * bend));
  const double slope = of_ratio.c[1] + 2 * x * of_ratio.c[2];
  return Estimate{of_ratio.c.dot(Eigen::Vector3d(1, x, x * x)),
                  std::fabs(slope) * std::sqrt(gradient.dot(of_q.covariance * gradient))};
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
  explicit Ending(std::span<const PathSample> samples)
      : samples_(samples),
        reading_(samples.back().signal[Signal::reading]),
        q_(at_last(samples, Signal::q)),
        p_(at_last(samples, Signal::p_eff)),
        ratio_(at_last(samples, ratio_of)) {}

  const AtLast& ratio() const { return ratio_; }
  bool has_passed_peak() const {
    return std::copysign(1.0, q_.value) * q_.rate < -kPassed * q_.rate_error;
  }
  /// q where the ratio is η: on the way to the peak, or back along the readings.
  double q_at(double eta) const {
    const double ahead = (eta - ratio_.value) / ratio_.rate;
    return ahead > 0 ? q_.value + q_.rate * ahead / 2 : q_.before(ahead);
  }
  PathPoint point_at(double eta) const;
  StressError error() const { return {q_.value_error, p_.value_error, ratio_.value_error}; }

 private:
  std::span<const PathSample> samples_;
  double reading_;
  AtLast q_, p_, ratio_;
};

PathPoint Ending::point_at(double eta) const {
  const double ahead = ratio_.rate != 0 ? (eta - ratio_.value) / ratio_.rate : 0;
  const auto along = [&](Signal signal, double readings) {
    const AtLast at = at_last(samples_, signal);
    return readings > 0 ? at.value + at.rate * readings : at.before(readings);
  };
  const double time_left = ahead > 0 ? ahead / 2 : ahead;
  PathPoint p;
  p.reading = reading_ + std::min(std::round(time_left), 0.0);
  p.progress = along(Signal::progress, time_left);
  p.q = q_at(eta);
  p.p_eff = p.q / eta;
  p.axial_strain = along(Signal::axial_strain, ahead);
  p.volumetric_strain = along(Signal::volumetric_strain, ahead);
  p.pore_pressure = along(Signal::pore_pressure, ahead);
  return p;
}

}  // namespace

std::optional<FallFit> fit_fall(std::span<const PathSample> samples, bool held_q) {
  if (samples.size() < kLeast) return std::nullopt;
  const Ending ending(samples);
  const AtLast& ratio = ending.ratio();
  FallFit fit;
  if (held_q) {
    fit.point = ending.point_at(ratio.value);
    StressSpan span(fit.point.q, fit.point.p_eff);
    for (const double readings : {-kYields, 1.0}) {
      const double eta = ratio.value + readings * ratio.rate;
      span.reach(fit.point.q, fit.point.q / eta);
    }
    fit.interval = span.interval(ending.error());
    return fit;
  }
  const double sense = std::copysign(1.0, ratio.value);
  if (!(sense * ratio.rate > 0)) return std::nullopt;
  const auto root = root_of_modulus(samples);
  Estimate eta{ratio.value + ratio.rate,
               std::hypot(ratio.rate / std::sqrt(3.0), ratio.value_error, ratio.rate_error)};
  if (ending.has_passed_peak()) {
    const auto vertex = vertex_of_q(samples);
    if (root && vertex)
      eta = both(*root, *vertex);
    else if (root || vertex)
      eta = root ? *root : *vertex;
  } else if (root) {
    eta = both(*root, eta);
  }
  fit.point = ending.point_at(eta.value);
  StressSpan span(fit.point.q, fit.point.p_eff);
  for (const double end : {-1.0, 1.0}) {
    const double there = eta.value + end * StressSpan::kOf95 * eta.error;
    span.reach(ending.q_at(there), ending.q_at(there) / there);
  }
  fit.interval = span.interval(ending.error());
  return fit;
}

}  // namespace triax::lab
