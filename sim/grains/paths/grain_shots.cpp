// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/paths/grain_shots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/critical_time_step.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::sim {
namespace {

using Pair = Vector<Axisymmetric>;
using Square = Matrix<Axisymmetric>;

/// Shares of the elastic stiffness that is mixed in where the secant one meets nothing, and the
/// share of the elastic determinant below which it does.
constexpr std::array kMixed{0.0, 0.01, 0.03, 0.1, 0.3, 1.0};
constexpr double kSingular = 0.01;
constexpr double kRunawayOverElastic = 30;
/// A strain may grow by so many times from one shot to the next.
constexpr double kGrowth = 3;
/// Share of the strain that a correction may take back.
constexpr double kTakenBack = 0.7;
/// Shots from which on the tolerance grows, by √10 each.
constexpr int kExact = 2;
/// Steps are planned anew where the strain has changed by more than this factor.
constexpr double kReplanned = 1.5;

class Meeting {
 public:
  Meeting(const GrainState& from, const SecantStiffness& secant,
          const PreparedControl<Axisymmetric>& control, double fraction, const ShotLimits& limits)
      : from_(from),
        secant_(secant),
        control_(control),
        wanted_(fraction * control.increment),
        limits_(limits),
        elastic_matrix_(matrix(secant.elastic)),
        elastic_size_(Pair(elastic_matrix_.inverse() * wanted_).norm()),
        bound_(std::max(limits.runaway_strain, kRunawayOverElastic * elastic_size_)) {}

  Shot run() {
    Pair strain = first();
    Square stiffness = secant_.towards(strain);
    StrainSteps steps;
    double planned_for = 0;
    Shot best;
    Pair last_strain = Pair::Zero(), last_stress = last_strain;
    for (int i = 1; i <= limits_.most_shots; ++i) {
      const double size = strain.norm();
      if (!(size > planned_for / kReplanned && size < planned_for * kReplanned)) {
        steps = strain_steps(from_, size, limits_.pace);
        planned_for = size;
      }
      Shot shot = shoot(from_, strain, steps);
      const Pair residual = missed(shot);
      shot.missed_pa = residual.norm();
      if (const Pair moved = strain - last_strain; moved.norm() > 0)
        stiffness = corrected(stiffness, moved, shot.stress - last_stress);
      last_strain = strain;
      last_stress = shot.stress;
      const bool better = i == 1 || shot.missed_pa < best.missed_pa;
      if (better) best = std::move(shot);
      best.shots = i;
      best.stiffness = stiffness;
      best.met = best.missed_pa <= tolerance(i);
      if (best.met) return best;
      strain += next(strain, stiffness, residual);
      if (strain.norm() > bound_) {
        best.ran_away = true;
        return best;
      }
    }
    return best;
  }

 private:
  Square matrix(const Square& stiffness) const {
    return control_.stress * stiffness + control_.strain;
  }
  Pair missed(const Shot& shot) const {
    return wanted_ - control_.stress * shot.stress - control_.strain * shot.strain;
  }
  Pair first() const {
    const double longest = std::max(kGrowth * kRunawayOverElastic * elastic_size_, 1e-12);
    const Pair going_on = correction(secant_.going_on, wanted_, longest);
    return going_on.dot(secant_.direction) < 0 ? correction(secant_.elastic, wanted_, longest)
                                               : going_on;
  }
  /// The grains jump now and then; what they miss by is made up for by whoever asks for totals.
  double tolerance(int shot) const {
    const double looser = std::pow(10.0, 0.5 * std::max(0, shot - kExact));
    return limits_.stress_tolerance_pa * std::min(looser, limits_.most_loosened);
  }
  /// The next correction, not far back: near a peak the stiffness says little.
  Pair next(const Pair& strain, const Square& stiffness, const Pair& residual) const {
    const double size = strain.norm();
    // What the grains do of themselves may be more than what was asked.
    const double elastic = Pair(elastic_matrix_.inverse() * residual).norm();
    const Pair more = correction(stiffness, residual, kGrowth * std::max(size, elastic));
    const bool far_back = more.dot(strain) < 0 && more.norm() > kTakenBack * size;
    return far_back ? Pair(more * (kTakenBack * size / more.norm())) : more;
  }
  /// With as little of the elastic stiffness mixed in as makes it regular and not too long.
  Pair correction(const Square& stiffness, const Pair& residual, double longest) const {
    Pair strain = Pair::Zero();
    for (const double share : kMixed) {
      const Square a = matrix(stiffness + share * (secant_.elastic - stiffness));
      if (!(a.determinant() / elastic_matrix_.determinant() > kSingular)) continue;
      strain = a.inverse() * residual;
      if (strain.norm() <= longest) return strain;
    }
    return strain * (longest / strain.norm());
  }

  const GrainState& from_;
  const SecantStiffness& secant_;
  const PreparedControl<Axisymmetric>& control_;
  Pair wanted_;
  const ShotLimits& limits_;
  Square elastic_matrix_;
  double elastic_size_, bound_;
};

}  // namespace

Vector<Axisymmetric> stress_of(const GrainState& grains) {
  return components(axisymmetric_stress(grains));
}

Shot shoot(const GrainState& from, const Vector<Axisymmetric>& strain, const StrainSteps& steps) {
  Shot shot;
  Grains grains(from);
  strain_box(grains, strain, steps);
  require_inside(grains.state());
  grains.set_time_step(usual_time_step(grains.state()));
  shot.grains = grains.state();
  shot.stress = stress_of(shot.grains) - stress_of(from);
  shot.strain = components(axisymmetric_strain(from.box, shot.grains.box));
  shot.shots = 1;
  return shot;
}

Shot meet(const GrainState& from, const SecantStiffness& secant,
          const PreparedControl<Axisymmetric>& control, double fraction, const ShotLimits& limits) {
  return Meeting(from, secant, control, fraction, limits).run();
}

}  // namespace triax::sim
