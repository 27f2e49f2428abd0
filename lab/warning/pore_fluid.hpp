// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the pore fluid and the lines give way by, learned from a test before its shear: with air in
// the pores the volume changes with u though the valve is closed, and water that leaves is not all
// that the specimen contracts by.
//
// In a B check the skeleton is compressed by what the fluid gives way, undrained: dε_v = c du. Free
// air gives way by Boyle's law, c = a/P², P = u + 1 atm, and a skeleton of grains by dε_v = k d√p′,
// which drained consolidation shows. So a = k s, s = d√p′/d(−1/P). Where u falls in consolidation,
// as it does after a B check that is not taken back, the fluid swells and drives water out, too:
// what flows out is k (√p′ + s/P), and k its slope, near the p′ of the B check: not every skeleton
// goes with √p′ far. Pa; lines and water are in it.
#include <optional>

#include "lab/results/record_header.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

class PoreFluid {
 public:
  /// The next state before shear; `stage` may be null. Pre-condition: complete(state).
  void add(const State& state, const StageInfo* stage);
  /// c at that pore pressure, 1/Pa; 0 where no B check and consolidation show it.
  double compliance(double u_pa) const;
  /// (1 − B)/B of the B check: c times the stiffness of the skeleton; empty without a check.
  std::optional<double> give() const;
  /// ∫c du: volumetric strain beside what flows out, up to a constant.
  double strain(double u_pa) const;

 private:
  /// Slope of a line by least squares, in constant memory.
  struct Line {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    void add(double at, double value);
    double variance() const { return xx / n - x * x / (n * n); }  ///< of where it was taken
    double slope() const { return (xy - x * y / n) / (xx - x * x / n); }
  };
  void start_stage(const State& state);
  double a() const;

  std::optional<int> stage_;
  double checked_from_ = 0, checked_ = 0;    ///< u over the B check, Pa
  double checked_p_ = 0;                     ///< the largest p′ of it, Pa
  double cell_from_ = 0, cell_ = 0;          ///< likewise the total lateral stress
  double drained_ = 0, drained_before_ = 0;  ///< ε_v of consolidation, before the stage
  Line b_check_, consolidation_;             ///< √p′ over −1/P, ε_v over √p′ + s/P
};

}  // namespace triax::lab
