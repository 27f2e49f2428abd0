// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/results/record_header.hpp"
#include "sim/specimen/specimen.hpp"

namespace triax::lab {

/// Share of the height by which no run-away goes that finds a new equilibrium as a slip does.
inline constexpr double kLeastFall = 0.01;

/// Watches the noise-free path of a simulated specimen for its own loss of sustainability: the
/// first instant of shear at which the second-order work dσ′:dε of the increment that the programme
/// takes turns negative and stays negative over a strain path ∫|dε| of kLastingPath. Elastic
/// increments have positive work, so neither a stage change nor a servo's search can trigger it.
/// Increments are added up to a strain path of kIncrement first: what a noisy servo does to the
/// specimen from tick to tick is not the increment that the programme takes.
/// So are the swings of a slip, a run-away that finds a new equilibrium within kLeastFall of the
/// height: they are left out, and whatever they seemed to show.
/// The instant is interpolated between the middles of the two increments around the change of sign.
class TruthWatch {
 public:
  static constexpr double kLastingPath = 1e-4;
  static constexpr double kIncrement = 1e-5;
  /// Share of an increment below which nothing moved: an increment begins after that, however long
  /// the specimen rested.
  static constexpr double kStill = 1e-4;

  /// Of a law that is not smooth (grains: now and then some of them jump) only what is much longer
  /// tells: strain paths of increments and of how long the work has to stay negative.
  struct Lengths {
    double increment = kIncrement, lasting = kLastingPath;
  };
  TruthWatch() = default;
  explicit TruthWatch(const Lengths& lengths) : lengths_(lengths) {}

  /// One increment of the path, in order. `height_at_shear_m` is the height when shear began.
  void watch(double time_s, double dt_s, const sim::SpecimenState& before,
             const sim::SpecimenStep& step, bool shear, double height_at_shear_m);

  Truth truth() const { return now_.confirmed ? now_.truth : Truth{}; }

 private:
  struct Middle {
    double time_s, work;
    sim::SpecimenState before, after;
    double dt_s;
  };
  /// Increments that are being added up.
  struct Sum {
    double start_s = 0, dt_s = 0, path = 0;
    sim::SpecimenState before;
    sim::AxisymmetricStress stress;
    sim::AxisymmetricStrain strain;
  };
  /// All that was seen so far.
  struct Known {
    std::optional<Sum> sum;
    std::optional<Middle> last;
    bool pending = false, confirmed = false;
    double path = 0;  ///< since it is pending
    Truth truth;
  };
  void open(const Middle& now, double height_at_shear_m);
  void add(double time_s, double dt_s, const sim::SpecimenState& before,
           const sim::SpecimenStep& step, double height_at_shear_m);

  Lengths lengths_;
  Known now_;
  std::optional<Known> before_run_away_;  ///< while one is under way
};

/// The truth of a specimen that lost its equilibrium in this state, whatever its second-order work:
/// a load on an area that shrinks runs away while dσ′:dε is positive yet.
Truth lost_equilibrium(double time_s, const sim::SpecimenState& state, double height_at_shear_m);

/// Whether the last run-away found no new equilibrium: it came to the end of the travel, or is
/// under way and has gone further than any slip, by kLeastFall of the height.
bool fell(const sim::SpecimenState& state);

/// What second-order work tells, unless it turned in the fall only, after kLeastFall of strain.
Truth earlier_of(const Truth& by_work, const Truth& by_fall);

}  // namespace triax::lab
