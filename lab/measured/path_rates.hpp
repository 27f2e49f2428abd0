// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rates of the measured path from noisy signals, and with them its second-order work.
//
// Neighbouring readings give increments of random sign. Here each point comes from the shortest
// window, among dyadic lengths, over which the normalised second-order work is resolved: its
// standard error, from the scatter about the local parabolas, is below kTolerance, or no longer
// window does better. Windows therefore follow the noise: a few readings in a collapse, thousands
// in a slow drained stage.
#include <cmath>
#include <functional>
#include <optional>

#include "lab/measured/local_fit.hpp"
#include "lab/results/second_order_work_point.hpp"

namespace triax::lab {

/// The path at one instant: smoothed values, rates per unit of progress, second-order work.
struct PathPoint {
  double reading = 0;
  double progress = 0;
  double q = 0, p_eff = 0, axial_strain = 0, volumetric_strain = 0, pore_pressure = 0;
  double q_rate = 0, p_rate = 0, axial_rate = 0, volumetric_rate = 0, pore_rate = 0;
  double q_rate_error = 0, p_rate_error = 0, axial_rate_error = 0, volumetric_rate_error = 0,
         pore_rate_error = 0;
  sim::SecondOrderWork work;
  double normalised_error = 0;
  double stress_variance = 0;  ///< of the smoothed (p', q) as a vector, Pa²
  double strain_variance = 0;  ///< of the smoothed strains as a vector
  std::int64_t window_readings = 0;
  /// The drive stood before it (AxisRest): what q fell meanwhile is relaxation.
  bool after_rest = false;

  /// The middle block itself, unsmoothed: the reading where the window is the shortest.
  PathSample middle;
  bool shortest_window() const { return window_readings == BlockPyramid::kBlocks; }

  double eta() const { return q / p_eff; }
  /// |q|: what is lost in a collapse, in compression as in extension (q < 0).
  double strength() const { return std::fabs(q); }
  /// Negative beyond what scatter explains (three standard errors).
  bool significantly_negative() const { return work.normalised < -3 * normalised_error; }
  bool significantly_positive() const { return work.normalised > 3 * normalised_error; }
};

/// The point with the middle block's own values in place of the smoothed ones.
PathPoint unsmoothed(PathPoint point);

/// An increment of the path, or a rate.
struct PathStep {
  double q = 0, p = 0, axial = 0, volumetric = 0;
};

/// Bound on the standard error of the normalised second-order work of a step whose stress and
/// strain vectors have these variances. It is the cosine between two directions, and a direction is
/// known as well as its vector: δw² ≤ (δS/S)² + (δE/E)². Unlike the derivative of the cosine the
/// bound does not vanish at ±1, where two vectors of pure noise would look certain. At most 2:
/// nothing is known.
double direction_error(const PathStep& step, double stress_variance, double strain_variance);
/// dσ′:dε/(|dσ′||dε|) of a step, Eq. (23).
double normalised_second_order_work(const PathStep& step);

class PathRates {
 public:
  static constexpr double kTolerance = 0.04;

  /// Points come in the order of their readings, each nearest to a reading of its own: it is stored
  /// beside that.
  std::function<void(const PathPoint&)> on_point;

  void add(const PathSample& sample);
  /// The rest of the last window, from the parabola's outer half, then forgets all: the next sample
  /// starts a new stage.
  void finish();

 private:
  struct Level {
    LocalFit::Values noise{};  ///< running mean of the scatter about the parabolas
    int fits = 0;
    double error = 0;  ///< of the latest point at this level
    int rest = 0;      ///< windows still to be passed over, after one that resolved nothing
  };
  PathPoint point_at(const LocalFit& fit, int level, double offset) const;
  static void learn(const LocalFit& fit, Level& level);
  bool resolves(const PathPoint& point, int level) const;
  void hand_on(const PathPoint& point);

  BlockPyramid pyramid_;
  std::array<Level, BlockPyramid::kLevels> levels_{};
  double last_reading_ = -1;
  LocalFit last_fit_;
  int last_level_ = -1;
};

}  // namespace triax::lab
