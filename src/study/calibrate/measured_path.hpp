// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The shear of a test as a law can be driven through it. SI, compression positive, strains since
// the start of shear.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace triax::study {

/// What was imposed on the soil, as the driver imposes it; the other two are computed.
enum class Imposed {
  undrained,    ///< ε₁ at ε_v = 0: q and p′ follow (u is the total mean stress less p′)
  drained,      ///< ε₁ and σ₃′: q and ε_v follow
  stress_path,  ///< p′ and q (constant q, dead load): ε₁ and ε_v follow
};
/// "undrained"
std::string_view to_string(Imposed imposed);

/// A quantity that is compared.
enum class Compared { q, p_eff, volumetric_strain, axial_strain };
/// "q_kPa", "p_eff_kPa", "volumetric_strain", "axial_strain"
std::string_view to_string(Compared quantity);
/// The two that follow from what is imposed.
std::array<Compared, 2> compared_in(Imposed imposed);

struct PathKnot {
  double axial_strain = 0, volumetric_strain = 0;
  double p_eff = 0, q = 0;  ///< Pa
  double weight = 0;        ///< share of the arc length of the path that it stands for; Σ = 1

  double value(Compared quantity) const;
  double radial_stress() const { return p_eff - q / 3; }  ///< σ₃′, Pa
};

struct MeasuredPath {
  std::int64_t test = 0;  ///< number in the database; 0: none
  std::string name;
  std::string material;  ///< as the record calls it; may be empty
  bool simulated = false;
  Imposed imposed = Imposed::undrained;
  double void_ratio = 0;  ///< at the start
  PathKnot start;         ///< its weight means nothing
  std::vector<PathKnot> knots;
  /// Of the two compared quantities: standard deviation of a single value.
  std::array<double, 2> noise{};
  /// Of the same: the span that the measured values cover.
  std::array<double, 2> span{};
  /// What a difference is divided by: √(noise² + (kAccuracy span)²).
  std::array<double, 2> scale{};
  /// q/p′ at the onset of collapse and its standard error; empty: the test did not collapse.
  std::optional<double> onset_eta;
  double onset_eta_error = 0;
};

/// The knot whose q/p′ is nearest to that of the onset; empty: the test did not collapse.
std::optional<PathKnot> onset_knot(const MeasuredPath& path);

/// Share of a quantity's span to which a law is expected to follow it.
inline constexpr double kAccuracy = 0.02;

/// Readings of shear, in order, as one path. All in SI.
struct ShearReading {
  double axial_strain = 0, volumetric_strain = 0, p_eff = 0, q = 0;
};

struct PathOptions {
  int knots = 60;
};

/// Fills knots, weights, noise, span and scale of `path` (whose `imposed` and `start` are given)
/// from its readings. Arc length is measured in the plane of the two quantities over their spans
/// and of the axial strain over its own, so that slow parts with many readings count no more. A
/// knot is a reading, never a mean: nothing is smoothed away at the start or at a peak. Knots are
/// left out where the strain goes back by no more than its noise, and the path ends where p′ falls
/// below 1 % of its start, where laws end. Throws std::invalid_argument where fewer than five knots
/// remain.
void lay_knots(MeasuredPath& path, const std::vector<ShearReading>& readings,
               const PathOptions& options = {});

}  // namespace triax::study
