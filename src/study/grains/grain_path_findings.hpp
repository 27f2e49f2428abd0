// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the points of a path of a specimen of grains show. Compression positive, SI.
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/grains/paths/grain_path.hpp"

namespace triax::study {

/// Second-order work of the increment between two points, per volume, Eq. (30) of Darve, Sibille,
/// Daouadji and Nicot (2007), J/m³:
///
///   W₂ = d(σ₁ − σ₃/R) dε₁ + dσ₃ (dε₁ + 2R dε₃)/R
///
/// which for any R is dσ₁ dε₁ + 2 dσ₃ dε₃. Pre-condition: ratio R > 0.
double second_order_work(const sim::GrainPathPoint& from, const sim::GrainPathPoint& to,
                         double ratio);

struct GrainPeak {
  std::size_t point = 0;  ///< of the path's points
  double value = 0;
  double axial_strain = 0;
  bool fell = false;  ///< afterwards it was lower by more than kFallen of itself
};

/// Largest values in the sense of the loading: the smallest where ε₁ is driven to extension.
struct GrainPathFindings {
  /// Empty: an isotropic path, or no point.
  std::optional<GrainPeak> q;
  std::optional<GrainPeak> eta;          ///< of the points with p above kMinP of the first one's
  std::optional<GrainPeak> path_stress;  ///< σ₁ − σ₃/R; of strain paths only
  /// Where W₂ of the increment over work_window() points is first negative and stays so for as many
  /// increments of that length more (half as many at the end): the point in its middle. Empty too
  /// where the path's samples are not known (0).
  std::optional<std::size_t> first_negative;
  double most_kinetic_j = 0;
};

/// A twentieth of the points that a whole path has, five at least: grains rearrange in bursts.
constexpr std::size_t work_window(int samples) {
  return samples < 100 ? 5 : static_cast<std::size_t>(samples) / 20;
}
inline constexpr double kFallen = 0.01;
/// η of a specimen that has all but lost its stress is the ratio of two noises.
inline constexpr double kMinP = 0.1;

GrainPathFindings path_findings(const sim::GrainPath& path,
                                const std::vector<sim::GrainPathPoint>& points);

}  // namespace triax::study
