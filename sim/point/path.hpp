// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A path: what is asked of one material point, segment after segment. SI, compression positive.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "sim/control/mixed_control.hpp"
#include "sim/law/law.hpp"

namespace triax::sim {

/// What an end condition can look at. Of a tensor, "axial" is component 11, "radial" the mean of 22
/// and 33, and q = √(3/2)|s| ≥ 0. Strains count from the start of the path.
enum class PathQuantity {
  axial_strain,
  radial_strain,
  volumetric_strain,
  shear_strain,           ///< 2(ε₁ − ε₃)/3
  mean_effective_stress,  ///< p′, Pa
  mean_total_stress,      ///< p, Pa
  deviator_stress,        ///< q, Pa
  stress_ratio,           ///< η = q/p′; has no value where p′ ≤ 0
  axial_stress,           ///< total, Pa
  radial_stress,          ///< total, Pa
  effective_axial_stress,
  effective_radial_stress,
  pore_pressure,
  void_ratio,
  strain_component,            ///< `component` of a tensor; shear: ε₁₂, not 2ε₁₂
  stress_component,            ///< total
  effective_stress_component,  ///< effective
};

/// True once the quantity is at or beyond the bound. Exactly one bound is set.
struct PathEnd {
  PathQuantity quantity = PathQuantity::axial_strain;
  int component = 0;  ///< 0 to 5: 11, 22, 33, 12, 13, 23
  std::optional<double> above, below;
  std::string label;  ///< for people: "stress_ratio above 0.3"
};

/// A stretch of the path with one set of conditions, which are ramped together from zero to their
/// totals.
template <class Space>
struct Segment {
  std::string name;
  /// Conditions on the increments of TOTAL stress and strain over the whole segment,
  /// S (dσ′ + δ du) + E dε = dy. In a drained segment du = 0.
  MixedControl<Space> conditions;
  /// What each row is called where it cannot be held: "q_kPa", "axial_strain + 1.65 radial_strain".
  std::vector<std::string> labels;
  bool undrained = false;    ///< dε_v = 0 besides, and the pore pressure follows from it
  int rows = 200;            ///< of output, equal parts of the segment; results do not depend on it
  std::vector<PathEnd> end;  ///< any of them ends the segment; one that is met already, at once
  int repeat = 1;            ///< times the stretch from `repeat_from` to this segment is run in all
  std::optional<std::size_t> repeat_from;  ///< empty: this segment alone
  /// The stretch of a table behind its first: left out where an end condition ended the one before.
  bool goes_on = false;
  /// Parts in which events are looked for, at least: one that comes and goes within a part is not
  /// seen.
  int least_parts = 200;
};

template <class Space>
struct Path {
  Vector<Space> stress = Vector<Space>::Zero();  ///< σ′ at the start
  double void_ratio = 0;
  double pore_pressure = 0;
  std::vector<double> memory;  ///< of the law; empty: as it is without any history of shear
  std::vector<Segment<Space>> segments;
};

/// Equal parts that a segment is run in: as many to each row as make `least_parts` of them.
template <class Space>
int parts_of(const Segment<Space>& segment) {
  const int rows = segment.rows, least = std::max(segment.least_parts, 1);
  return rows * ((least + rows - 1) / rows);
}

/// A segment's conditions in effective stress. Of an undrained segment one condition, which must
/// fix a total stress (a_i = S_i·δ ≠ 0), gives the pore pressure and leaves its place to
/// dε_v = 0:
///
///   du = (dy_i − S_i·dσ′ − E_i·dε)/a_i,   row j ≠ i: row_j − (a_j/a_i) row_i,   row i: δ·dε = 0
///
/// Of several the one with dy_i = 0 is taken, since the others may be found wanting by name.
template <class Space>
struct EffectiveControl {
  MixedControl<Space> control;  ///< on dσ′ and dε
  std::vector<std::string> labels;
  bool undrained = false;
  double pore_pressure = 0;                                    ///< dy_i/a_i, Pa
  Vector<Space> pore_pressure_stress = Vector<Space>::Zero();  ///< S_i/a_i
  Vector<Space> pore_pressure_strain = Vector<Space>::Zero();  ///< E_i/a_i, Pa

  /// du over this fraction of the segment, in which stress and strain change so.
  double pore_pressure_change(double fraction, const Vector<Space>& stress,
                              const Vector<Space>& strain) const;
};

/// The conditions of a triaxial segment asked of a tensor with axis 1 as the axial one: axes 2 and
/// 3 are kept equal (in stress where no condition is on strain, else in strain), shear strains as
/// they are.
Segment<Tensor> as_tensor_segment(const Segment<Axisymmetric>& segment);

/// The segments in the order in which they are run, repetitions written out. Throws
/// std::invalid_argument where that is more than a million.
template <class Space>
std::vector<std::size_t> segment_order(const Path<Space>& path);

/// Throws std::invalid_argument in words: no condition fixes a total stress, or the conditions
/// depend on each other.
template <class Space>
EffectiveControl<Space> effective_control(const Segment<Space>& segment);

}  // namespace triax::sim
