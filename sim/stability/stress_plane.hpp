// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>

#include "sim/stability/incremental_response.hpp"

namespace triax::sim {

/// The answer of a state to stress increments within the plane of probes (probe.hpp), prepared once
/// so that a direction costs little. Only two strains are free in either plane, so that a stiffness
/// form is one of two unknowns (in plane strain its components 1 and 3; |dε| has no others). Of an
/// interpolated form in plane strain one unknown is left, dσ₂ with
///
///   dε₂(dσ₁, dσ₂, dσ₃) = 0,
///
/// found in closed form for octolinear and by Newton's method for INL2. Agrees with
/// IncrementalResponse::to() to round-off.
template <class Space>
class StressPlane {
 public:
  struct Answer {
    bool answered = false;
    bool refused = false;  ///< not answered because the law refuses the direction
    double axial_strain = 0, radial_strain = 0;  ///< components 1 and 3 (√2 ε₃ in axisymmetry)
  };

  /// Pre-condition: !response.law().finite()
  explicit StressPlane(std::shared_ptr<const IncrementalResponse<Space>> response);

  /// To the components 1 and 3 of dσ (√2 dσ₃ in axisymmetry), not both zero. Empty where only
  /// IncrementalResponse::to() can tell: near the limit of an interpolated form in plane strain.
  std::optional<Answer> to(double axial, double radial) const;

 private:
  PointRate<Axisymmetric> stiff(double axial, double radial) const;
  std::optional<double> across(double axial, double radial) const;
  Eigen::Vector3d principal_strain(const Eigen::Vector3d& stress) const;
  Answer accepted(const PointRate<Space>& rate) const;
  PointRate<Space> whole(const PointRate<Axisymmetric>& rate) const;

  std::shared_ptr<const IncrementalResponse<Space>> response_;
  Response<Axisymmetric> plane_;                          // stiffness form of two unknowns
  std::optional<PreparedControl<Axisymmetric>> control_;  // of it
  std::optional<InterpolatedCompliance<Axisymmetric>> compliance_;  // interpolated, axisymmetry
  Eigen::Matrix3d mean_, half_;                                     // interpolated, plane strain
  bool quadratic_ = false;
};

extern template class StressPlane<Axisymmetric>;
extern template class StressPlane<Tensor>;

}  // namespace triax::sim
