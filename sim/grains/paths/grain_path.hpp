// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Loading paths of a specimen of grains. Compression positive, strains natural, since the start of
// the path; axis 1 as triaxial_axes.hpp has it.
//
//   isotropic     all stresses run to a pressure
//   drained       σ₃ held
//   strain_path   dε₁ + 2R dε₃ = 0 (Eq. 28); R = 1 is undrained (constant volume)
//
// Axis 1 of the latter two goes by strain, ε̇₁ given, or by load: what is conjugate to ε₁ rises at a
// given rate, σ₁ of a drained path, σ₁ − σ₃/R of a strain path. Under load the specimen runs away
// where it cannot carry more.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sim/grains/engine/grain_ledger.hpp"
#include "sim/grains/state/grain_progress.hpp"
#include "sim/grains/state/grain_state.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::sim {

enum class GrainPathKind : std::uint8_t { isotropic, drained, strain_path };

/// A state that is taken out at the first check at which a quantity has passed a value.
struct PathMark {
  enum class Quantity : std::uint8_t { stress_ratio, path_stress_pa, axial_strain };
  Quantity quantity = Quantity::stress_ratio;  ///< η = q/p, σ₁ − σ₃/R, or ε₁
  double value = 0;
  bool falling = false;  ///< passed from above; only after the quantity was above it
};

struct GrainPath {
  GrainPathKind kind = GrainPathKind::drained;
  double pressure_pa = 1e5;         ///< isotropic: goal; drained: σ₃. > 0
  double strain_rate_per_s = 0.1;   ///< ε̇₁ of drained and strain paths by strain, ≠ 0
  double stress_rate_pa_per_s = 0;  ///< isotropic: of the target, ≥ 0; 0 sets the goal at once
  /// Drained and strain paths: ≠ 0 drives axis 1 by load at this rate, negative in extension.
  double load_rate_pa_per_s = 0;
  double ratio = 1;  ///< R of a strain path, and of path_stress_pa; > 0

  double axial_strain = 0.02;  ///< the path ends at this |ε₁| (drained, strain path), > 0
  /// It ends where η reaches this: from below in compression, from above in extension.
  std::optional<double> stress_ratio;
  /// It has collapsed where p falls below this share of what it was at the start, ≥ 0.
  double collapse_share = 0.01;
  /// Isotropic: at rest where unbalanced is below this and stresses are as near to the pressure.
  double unbalanced = 1e-4, pressure_share = 1e-3;
  std::int64_t most_steps = 20000000;

  int samples = 200;              ///< points kept besides the first and the last, > 0
  std::int64_t check_every = 20;  ///< steps between looks at ends and marks, > 0
  std::vector<PathMark> marks;
};

struct GrainPathPoint {
  double time_s = 0;  ///< since the start
  AxisymmetricStrain strain;
  double volumetric_strain = 0;
  AxisymmetricStress stress;  ///< Pa
  double p_pa = 0, q_pa = 0;
  double path_stress_pa = 0;    ///< σ₁ − σ₃/R
  double kinetic_energy_j = 0;  ///< the most since the point before
  double unbalanced = 0, porosity = 0, coordination = 0;
  double sliding_share = 0;  ///< of contacts between grains

  double stress_ratio() const { return p_pa > 0 ? q_pa / p_pa : 0; }
};

enum class GrainPathEnd : std::uint8_t {
  axial_strain,
  stress_ratio,
  at_rest,  ///< isotropic: at rest at the pressure
  collapse,
  most_steps,
  stopped  ///< by the progress
};

struct GrainPathResult {
  std::vector<GrainPathPoint> points;  ///< at most samples + 2
  GrainPathEnd end = GrainPathEnd::stopped;
  GrainState state;                               ///< at the end, still driven
  std::vector<std::optional<GrainState>> marked;  ///< as the marks; empty where never passed
  GrainLedger ledger;                             ///< from the end of the first step to the last
};

/// A point without history: strains since `start`.
GrainPathPoint path_point(const GrainState& state, const GrainBox& start, double ratio);

/// Told of every point when it is taken, with the state that it shows.
using GrainPathWatch = std::function<void(const GrainState&, const GrainPathPoint&)>;

/// Follows the path from `state` on `threads` threads (same bits on any). Throws GrainsFailed, also
/// when a grain lies outside, and std::invalid_argument on settings out of their ranges.
GrainPathResult follow(const GrainState& state, const GrainPath& path, int threads = 1,
                       const GrainProgress& progress = {}, const GrainPathWatch& watch = {});

}  // namespace triax::sim
