// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The record that the replay benchmark reads: an undrained test in closed form, as a logger writes
// it.
#include <cmath>
#include <numbers>
#include <random>

namespace triax::bench {

struct RawRow {
  double time_s, displacement_mm, force_kN, cell_kPa, back_kPa, pore_kPa, volume_mm3;
};

/// Row i of n: 12 mm of compression of a 140 mm by 70 mm specimen, q rising to a peak near 0.6 %
/// and falling, u rising; noise of 0.3 N and 60 Pa rms.
class SyntheticRecord {
 public:
  static constexpr double kHeight_mm = 140, kDiameter_mm = 70;

  /// `noise`: so many times that.
  explicit SyntheticRecord(long rows, double noise = 1) : rows_(rows), noise_(noise) {}

  RawRow row(long i) {
    const double mm = 12.0 * double(i) / double(rows_ - 1);
    const double strain = mm / kHeight_mm;
    const double area = std::numbers::pi * 0.035 * 0.035 / (1 - strain);
    const double pore = 500e3 + 250e3 * (1 - std::exp(-strain / 0.01));
    return {.time_s = 0.1 * double(i),
            .displacement_mm = mm,
            .force_kN = (q(strain) * area + 0.3 * noise_ * normal_(rng_)) / 1e3,
            .cell_kPa = (800e3 + 60 * noise_ * normal_(rng_)) / 1e3,
            .back_kPa = 500,
            .pore_kPa = (pore + 60 * noise_ * normal_(rng_)) / 1e3,
            .volume_mm3 = 0};
  }

  /// Deviator stress without noise, Pa.
  static double q(double strain) {
    const double x = strain / 0.006;
    return 140e3 * x * std::exp(1 - x) + 15e3 * strain / 0.08;
  }
  /// The row at which q truly peaks.
  long peak_row() const {
    long best = 0;
    for (long i = 0; i < rows_; ++i) {
      const double scale = 12.0 / kHeight_mm / double(rows_ - 1);
      if (q(scale * double(i)) > q(scale * double(best))) best = i;
    }
    return best;
  }

 private:
  long rows_;
  double noise_;
  std::mt19937_64 rng_{1};
  std::normal_distribution<double> normal_;
};

}  // namespace triax::bench
