// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/last_readings.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lab/collapse/change_point.hpp"
#include "lab/collapse/stress_span.hpp"

namespace triax::lab {

ThreeTerms::ThreeTerms(const std::vector<Eigen::Vector3d>& terms, const std::vector<double>& y) {
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
  scatter = std::sqrt(square / static_cast<double>(y.size() - 3));
  covariance = inverse * (scatter * scatter);
}

double AtLast::error_at(double readings) const {
  const Eigen::Vector3d terms(1, readings, readings * readings);
  return std::sqrt(terms.dot(covariance * terms));
}

double AtLast::rate_error_at(double readings) const {
  const Eigen::Vector3d terms(0, 1, 2 * readings);
  return std::sqrt(terms.dot(covariance * terms));
}

AtLast at_last(std::span<const PathSample> samples,
               const std::function<double(const PathSample&)>& value, std::size_t readings) {
  const auto newest = samples.last(std::min(samples.size(), readings));
  const double last = newest.back().signal[PathSample::Signal::reading],
               origin = value(newest.back());
  std::vector<Eigen::Vector3d> terms;
  std::vector<double> y;
  for (const PathSample& s : newest) {
    const double x = s.signal[PathSample::Signal::reading] - last;
    terms.emplace_back(1, x, x * x);
    y.push_back(value(s) - origin);
  }
  const ThreeTerms fit(terms, y);
  return {origin + fit.c[0],
          fit.c[1],
          fit.c[2],
          std::sqrt(fit.covariance(0, 0)),
          std::sqrt(fit.covariance(1, 1)),
          fit.covariance,
          fit.scatter};
}

AtLast at_last(std::span<const PathSample> samples, PathSample::Signal signal,
               std::size_t readings) {
  return at_last(
      samples, [signal](const PathSample& s) { return s.signal[signal]; }, readings);
}

namespace {

/// Of parabolas through more or fewer of the last readings the one whose slope is known best.
std::optional<AtLast> best_at_last(std::span<const PathSample> samples, PathSample::Signal signal,
                                   std::size_t& of) {
  std::optional<AtLast> best;
  for (const std::size_t readings : {6U, 8U, 12U, 16U, 24U, 36U, 60U}) {
    if (readings > samples.size()) break;
    const AtLast at = at_last(samples, signal, readings);
    if (best && at.rate_error >= best->rate_error) continue;
    best = at;
    of = readings;
  }
  return best;
}

}  // namespace

bool contracts_at_end(std::span<const PathSample> samples, bool drained) {
  constexpr double kSure = ChangePoint::kSignificance;
  std::size_t of = 0;
  const auto volume = best_at_last(
      samples, drained ? PathSample::volumetric_strain : PathSample::pore_pressure, of);
  const auto p_eff = best_at_last(samples, PathSample::p_eff, of);
  return volume && volume->rate > kSure * volume->rate_error &&
         p_eff->rate < -kSure * p_eff->rate_error;
}

bool softens_at_end(std::span<const PathSample> samples, double mean_rate) {
  constexpr double kMovesOn = 0.5;
  std::size_t of = 0;
  const auto axial = best_at_last(samples, PathSample::axial_strain, of);
  if (!axial) return false;
  if (!(axial->rate / mean_rate >= kMovesOn)) return false;
  const auto volume = best_at_last(samples, PathSample::volumetric_strain, of);
  const auto q = best_at_last(samples, PathSample::q, of);
  const auto p_eff = best_at_last(samples, PathSample::p_eff, of);
  const double shear = axial->rate - volume->rate / 3;
  const double work = q->rate * shear + p_eff->rate * volume->rate;
  const double error = std::hypot(shear * q->rate_error, q->rate * axial->rate_error,
                                  volume->rate * p_eff->rate_error) +
                       std::fabs((p_eff->rate - q->rate / 3) * volume->rate_error);
  return work < -ChangePoint::kSignificance * error;
}

Turned may_have_turned(std::span<const PathSample> samples, PathSample::Signal signal) {
  Turned turned;
  const auto best = best_at_last(samples, signal, turned.of);
  if (!best) return turned;
  constexpr double kStep = 0.25;                                             // readings
  for (double x = 1 - static_cast<double>(turned.of); x <= 1; x += kStep) {  // NOLINT: exact
    if (std::fabs(best->rate_at(x)) > StressSpan::kOf95 * best->rate_error_at(x)) continue;
    if (!turned.anywhere()) turned.first = x;
    turned.last = x;
  }
  return turned;
}

namespace {

/// Slope of q over readings, and its standard error.
std::pair<double, double> mean_rate(std::span<const PathSample> part) {
  const auto n = static_cast<double>(part.size());
  double x = 0, q = 0;
  for (const PathSample& s : part) {
    x += s.signal[PathSample::Signal::reading] / n;
    q += s.signal[PathSample::q] / n;
  }
  double xx = 0, xq = 0, qq = 0;
  for (const PathSample& s : part) {
    const double dx = s.signal[PathSample::Signal::reading] - x, dq = s.signal[PathSample::q] - q;
    xx += dx * dx;
    xq += dx * dq;
    qq += dq * dq;
  }
  return {xq / xx, std::sqrt(std::max(qq - xq * xq / xx, 0.0) / ((n - 2) * xx))};
}

}  // namespace

bool grows_steadily(std::span<const PathSample> samples, double rate_of_stage) {
  constexpr double kShare = 0.7, kKnown = 1.0 / 3;
  constexpr std::size_t kFewest = 6;
  for (std::size_t readings = kFewest;; readings += readings / 2) {
    const bool all = readings >= samples.size();
    const auto [rate, error] = mean_rate(all ? samples : samples.last(readings));
    if (all || error < kKnown * std::fabs(rate_of_stage)) return rate / rate_of_stage > kShare;
  }
}

}  // namespace triax::lab
