// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How well the stresses at an onset are known: one model, whatever placed it.
#include "lab/results/summary.hpp"

namespace triax::lab {

/// Standard errors of a state: of q and p′, Pa, and of η, which is not that of two independent
/// numbers.
struct StressError {
  double q = 0, p_eff = 0, eta = 0;
};
/// Of single readings whose (p′, q) have this variance as a vector, Pa² (PathPoint): the most that
/// each of them may have of it.
StressError error_of_readings(double stress_variance, double q, double p_eff);

/// One model of the error of an onset, whatever placed it. The onset lies somewhere on a stretch of
/// the path: where a fit's root lies within its error, in the window that saw the change, in the
/// gap between two readings that hides it. Beside what the path does there stands, independent of
/// it, the error of the measured state:
///   v_low = v − √((v − v_least)² + (z σ)²),  v_high likewise,  z = 2.2
/// for v of q, p′ and η each; v is what is reported. Zero, scale and drift of the instruments are
/// no part of it.
class StressSpan {
 public:
  /// z: σ comes from the scatter of a dozen readings, Student's t of ten degrees of freedom.
  static constexpr double kOf95 = 2.2;

  StressSpan(double q, double p_eff);
  /// A state, Pa, that may be the onset's.
  void reach(double q, double p_eff);
  /// A q that may be the onset's, whatever p′ was then.
  void reach_q(double q);
  StressInterval interval(const StressError& error) const;

 private:
  double q_, p_, eta_;
  StressInterval reached_;
};

/// A state without error.
StressInterval as_interval(double q, double p_eff);
/// What holds both.
StressInterval hull(const StressInterval& a, const StressInterval& b);

}  // namespace triax::lab
