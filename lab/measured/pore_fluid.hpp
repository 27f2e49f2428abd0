// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Compliance of pore fluid, lines and transducer, learned from a test before its shear. With the
// valve closed the volume of the specimen changes by dε_v = c du; with it open by dε_v, measured +
// c du (compression positive).
//
// In a B check the skeleton is compressed undrained by that volume. Free air is compressed by
// Boyle's law, c = a/P² with P = u + 1 atm, and a skeleton of grains by dε_v = k d√p′, which
// drained consolidation shows. So a = k s with s = d√p′/d(−1/P). Where u falls in consolidation, as
// it does after a B check that is not taken back, the fluid expands and drives water out, too: what
// flows out is k (√p′ + s/P). k is its slope near the p′ of the B check, because not every skeleton
// follows √p′ far.
#include <optional>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// c(u) = rigid + air/P²: water, lines and transducer do not depend on u, free air does.
struct FluidCompliance {
  static constexpr double kAtmosphere_pa = 101.325e3;

  double rigid = 0;            ///< 1/Pa
  double air = 0;              ///< Pa
  double least = 1, most = 1;  ///< c lies between these times c(u) with 95 %

  double at(double u_pa) const;  ///< c, 1/Pa
  /// ∫c du: volumetric strain up to a constant.
  double strain(double u_pa) const;
};

class PoreFluid {
 public:
  /// The next state before shear; `stage` may be null. Pre-condition: complete(state).
  void add(const State& state, const StageInfo* stage);
  /// a, Pa; 0 where no B check and consolidation show it.
  double air() const;
  /// (1 − B)/B of the B check: c times the stiffness of the skeleton; empty without a check.
  std::optional<double> give() const;

  /// Compliance of a test that begins its shear at `u_pa`: median and 95 % interval of c given what
  /// the test showed and what is known before any test. Known before: ln c is normal, its
  /// median that of water in the voids and of 0.45 mm³/kPa of lines, its standard deviation a
  /// factor of 2.5 (0.07 to 2.7 mm³/kPa with 95 %). Shown: a/P² ± the errors of both slopes, of two
  /// transducers that differ by 0.2 %, and 0.3 c for skeletons that do not follow √p′.
  /// What exceeds that median is taken as free air. `volume_m3`: of the specimen; empty: 70 mm by
  /// 140 mm.
  FluidCompliance posterior(double u_pa, std::optional<double> volume_m3) const;

 private:
  /// Slope of a line by least squares and its standard error, in constant memory.
  struct Line {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  ///< means and sums of squared deviations
    void add(double at, double value);
    double variance() const { return xx / n; }  ///< of where it was taken
    double slope() const { return xy / xx; }
    double slope_error() const;
  };
  void start_stage(const State& state);
  double shown() const;
  /// Standard error of shown(), without that of the laws; infinite where nothing shows it.
  double shown_error() const;

  std::optional<int> stage_;
  double checked_from_ = 0, checked_ = 0;    ///< u over the B check, Pa
  double checked_p_ = 0;                     ///< the largest p′ of it, Pa
  double cell_from_ = 0, cell_ = 0;          ///< and the total lateral stress
  double drained_ = 0, drained_before_ = 0;  ///< ε_v of consolidation, before the stage
  Line b_check_, consolidation_;             ///< √p′ over −1/P, ε_v over √p′ + s/P
};

}  // namespace triax::lab
