// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/fall_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

using Signal = PathSample::Signal;
constexpr std::size_t kLeast = 8;
constexpr double kBeyond = 0.5;      ///< readings: the fall began between two of them
constexpr std::size_t kOfTime = 12;  ///< readings: farther back the parabola of t is none

/// A signal as c₀ + c₁x + c₂x² of x = (ε − ε_last)/scale.
class Parabola {
 public:
  Parabola(std::span<const PathSample> samples, Signal signal, double last, double scale);
  double operator()(double x) const { return c_[0] + x * (c_[1] + x * c_[2]); }
  /// Curved down, as a quantity is that passes a maximum.
  bool peaks() const { return c_[2] < 0; }
  double vertex() const { return -c_[1] / (2 * c_[2]); }
  double vertex_error() const {
    const Eigen::Vector3d gradient(0, -1 / (2 * c_[2]), c_[1] / (2 * c_[2] * c_[2]));
    return std::sqrt(variance_ * gradient.dot(inverse_ * gradient));
  }
  /// Where it reaches `value` on its rising side. Pre-condition: peaks(), value below the vertex's.
  double rising_to(double value) const {
    return vertex() - std::sqrt(((*this)(vertex()) - value) / -c_[2]);
  }

 private:
  Eigen::Vector3d c_;
  Eigen::Matrix3d inverse_;
  double variance_ = 0;
};

Parabola::Parabola(std::span<const PathSample> samples, Signal signal, double last, double scale) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const auto terms = [&](const PathSample& s) {
    const double x = (s.signal[Signal::axial_strain] - last) / scale;
    return Eigen::Vector3d(1, x, x * x);
  };
  const double origin = samples.back().signal[signal];
  for (const PathSample& s : samples) {
    const Eigen::Vector3d t = terms(s);
    normal += t * t.transpose();
    right += (s.signal[signal] - origin) * t;
  }
  inverse_ = normal.ldlt().solve(Eigen::Matrix3d::Identity());
  c_ = inverse_ * right;
  c_[0] += origin;
  double square = 0;
  for (const PathSample& s : samples) {
    const double residual = s.signal[signal] - c_.dot(terms(s));
    square += residual * residual;
  }
  variance_ = square / static_cast<double>(samples.size() - 3);
}

}  // namespace

std::optional<PathPoint> fit_fall(std::span<const PathSample> samples, bool held_q) {
  if (samples.size() < kLeast) return std::nullopt;
  const auto newest = samples.last(std::min(samples.size(), kOfTime));
  const PathSample& last = samples.back();
  const double strain = last.signal[Signal::axial_strain];
  const double scale = strain - samples.front().signal[Signal::axial_strain];
  if (!(scale > 0)) return std::nullopt;
  const Parabola time(newest, Signal::reading, strain, scale);
  if (!time.peaks()) return std::nullopt;

  const double bound = last.signal[Signal::reading] + kBeyond;
  const double vertex = time.vertex();
  double x = std::max(time(vertex) > bound ? time.rising_to(bound) : vertex, 0.0);
  if (!held_q) {
    const Parabola q(samples, Signal::q, strain, scale);
    if (q.peaks() && q.vertex() > -1 && q.vertex() < x - 3 * q.vertex_error()) x = q.vertex();
  }
  const auto value = [&](Signal signal) {
    return Parabola(x > 0 ? newest : samples, signal, strain, scale)(x);
  };
  PathPoint p;
  p.reading =
      std::min(Parabola(samples, Signal::reading, strain, scale)(x), last.signal[Signal::reading]);
  if (x >= 0) p.reading = last.signal[Signal::reading];
  p.progress = value(Signal::progress);
  p.q = value(Signal::q);
  p.p_eff = value(Signal::p_eff);
  p.axial_strain = strain + x * scale;
  p.volumetric_strain = value(Signal::volumetric_strain);
  p.pore_pressure = value(Signal::pore_pressure);
  return p;
}

}  // namespace triax::lab
