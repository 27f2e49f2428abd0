// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A specimen of grains in the place of a material point: the law asks the grains.
//
// An increment strains the box of a copy of the grains by walls, gently (box_strain.hpp), and reads
// the stress off the walls; conditions on stress are met by shots from the same state
// (grain_shots.hpp). The state is grains at rest. Time of the grains is not that of the test: below
// the bound of the pace the answer hardly depends on the rate, and no condition can tell how fast
// it was. Where a load is no longer carried the rate matters: control is then lost, and what the
// mass on the specimen does is for its owner (InertialMotion), who strains it.
//
// The cylinder that the state stands for has any size: the grains are its homogeneous element.
#include <cstdint>
#include <string>

#include "sim/grains/paths/grain_shots.hpp"
#include "sim/law/law.hpp"
#include "sim/point/self_driven.hpp"

namespace triax::sim {

struct GrainDriving {
  double inertial_number = 1e-4;     ///< of the pace, > 0
  double relative_tolerance = 1e-5;  ///< of conditions on stress, to p′ (or what it started with
                                     ///< times `least_share`, if that is more), > 0
  double least_share = 0.05;         ///< share of the first p′ below which nothing gets finer
};

class GrainLaw final : public Law<Axisymmetric>, public SelfDriven<Axisymmetric> {
 public:
  /// Takes the grains as they stand, walls stopped, calmed, their stress made isotropic to the
  /// tolerance. Throws std::invalid_argument, one line: a grain outside, no stress, not at rest
  /// (unbalanced above kMostUnbalanced), not isotropic (a wall's stress off the mean by more than
  /// kMostOff of it); GrainsFailed.
  explicit GrainLaw(const GrainState& state, const GrainDriving& how = {});
  static constexpr double kMostUnbalanced = 0.01, kMostOff = 0.02;

  std::int64_t grains() const;
  double void_ratio() const { return start_.void_ratio; }
  /// p′ that the grains stand under, Pa
  double pressure_pa() const { return pressure_pa_; }

  // Law
  /// The grains as they stand; at another stress or void ratio a state that the law objects to.
  State start(const Vector<Axisymmetric>& stress, double void_ratio) const override;
  std::optional<std::string> objection(const State& state) const override;
  /// A suspension is a state, too; walls carry no tension.
  bool carries_tension() const override { return true; }
  /// Linear, with what the last increments showed.
  using Law::response;
  void response(const State& state, Response<Axisymmetric>& out) const override;
  const SelfDriven<Axisymmetric>* self_driven() const override { return this; }

  // SelfDriven
  PointStep<Axisymmetric> drive(const State& state,
                                const MixedControl<Axisymmetric>& wanted) const override;
  /// By the secant stiffness of the last increments.
  Rate rate(const State& state, const MixedControl<Axisymmetric>& wanted) const override;
  bool sustains(const State& state, const MixedControl<Axisymmetric>& wanted) const override;
  DrivingTolerance tolerance(const State& state) const override;

 private:
  ShotLimits limits(const State& state) const;
  Shot taken(const State& state, const PreparedControl<Axisymmetric>& control,
             PointStep<Axisymmetric>& step) const;
  State after(const State& state, const Shot& shot) const;

  GrainDriving how_;
  double pressure_pa_ = 0, modulus_pa_ = 0;
  State start_;
};

/// The grains of a state of a GrainLaw. Pre-condition: the law does not object to it.
const GrainState& grains_of(const PointState<Axisymmetric>& state);

}  // namespace triax::sim
