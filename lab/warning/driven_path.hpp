// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a stage does to the specimen and what the specimen answers, as integrals over its raw
// readings: nothing is differentiated, so nothing waits for a window to be full.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/measured/specimen_volume.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Means over neighbouring readings. x is what the specimen is driven along and y what it answers
/// with: sustainability is lost where dy/dx falls to zero.
///
///   strain_path   x = ε₁, y = σ₁′ − σ₃′/R (q where R = 1): ε₁ + 2Rε₃ = 0 is kept, Eq. (28)
///   held_q_open   x = −p′, y = −ε_v: q is held, the drainage open; ε_v of the specimen
///                 (SpecimenVolume)
///   held_q_shut   x = −p′, y = −u: q is held, the valve closed, and the volume moves with u
struct PathMean {
  double readings = 0;  ///< how many it is of
  double progress = 0;  ///< seconds, or axial strain where there is no time
  double eta = 0;       ///< |q/p′|
  double p = 0, q = 0;  ///< p′, |q|, Pa
  double x = 0, y = 0;
  double beside = 0;  ///< p′ along a strain path, ε₁ at held q
  /// ∫ g η^k dx, k = 0, 1, 2, from the start of the stage, by trapezia; g = √p′ along a strain path
  /// (stiffness of grains in contact goes with it), else 1.
  std::array<double, 3> weighted{};
};

class DrivenPath {
 public:
  enum class Control { none, strain_path, held_q_open, held_q_shut };
  static constexpr std::size_t kMost = 128;

  /// None where q alone is no sign of a loss: the drainage open under prescribed displacement.
  static Control control_of(const StageInfo* stage);
  /// Whether that stage drives the specimen as the present one did before it went back in a loop:
  /// then it is the way back to the path.
  bool goes_on_in(const StageInfo* stage) const { return in_loop() && is_alike(stage); }
  /// Starts the path again. After a stage with the same control the largest η is kept: below it is
  /// a loop. `volume`: of the test, whose states with_fluid() are given to add().
  void start_stage(const StageInfo* stage, bool has_time, const SpecimenVolume& volume = {});
  Control control() const { return control_; }

  /// The next reading in shear. One that lies well below the largest η is left out; where several
  /// do in a row the specimen is in a loop of unloading, and the path goes on where the largest η
  /// is regained, as if x, y and what is beside had stood still. Pre-condition: complete(state).
  void add(const State& state);
  /// In order, kMost at most: where there are more readings, means of neighbours, about equal in η.
  const std::vector<PathMean>& means() const { return means_; }
  /// Of all readings of the stage that are in means().
  std::int64_t readings() const { return readings_; }
  bool in_extension() const { return in_extension_; }
  double ratio() const { return ratio_; }            ///< R of a strain path
  double compliance() const { return compliance_; }  ///< of the pore fluid at present, 1/Pa
  const SpecimenVolume& volume() const { return volume_; }

 private:
  PathMean sample(const State& state) const;
  bool is_alike(const StageInfo* stage) const;
  bool in_loop() const;
  void leave_out();
  void merge();

  Control control_ = Control::none;
  double ratio_ = 1;       ///< R
  SpecimenVolume volume_;  ///< as it is known where shear begins
  double compliance_ = 0;
  bool has_time_ = true, in_extension_ = false;
  std::int64_t readings_ = 0;
  int below_ = 0;                        ///< readings in a row below the largest η
  double highest_ = 0;                   ///< η, of two neighbours the lower
  double gone_y_ = 0, gone_beside_ = 0;  ///< by what was left out
  std::optional<PathMean> before_;       ///< the reading before, with its integrals
  std::vector<PathMean> means_;
};

}  // namespace triax::lab
