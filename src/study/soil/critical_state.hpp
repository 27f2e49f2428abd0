// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The critical state of one test: where stresses and volume are at rest while shear goes on.
#include <optional>
#include <string>
#include <string_view>

#include "src/study/soil/estimate.hpp"
#include "src/study/soil/shear_curve.hpp"

namespace triax::study {

/// `extrapolated`: the test ended before it came to rest, and where it would is estimated.
enum class CriticalKind { none, extrapolated, reached };
std::string_view to_string(CriticalKind kind);

struct CriticalState {
  CriticalKind kind = CriticalKind::none;
  std::string reason;  ///< of none, and what is left of an extrapolated one: half a sentence
  Estimate eta;        ///< |q|/p′
  Estimate log_p;      ///< ln(p′/1 kPa)
  std::optional<Estimate> void_ratio;
  double rate = 0;     ///< dε_v/dε_q at the end, or d ln p′/dε_q with the valve closed
  double eta_way = 0;  ///< by which η was extrapolated
};

/// Standard error of an extrapolation, as a share of its way: curves of one sand bend alike, so
/// that it is common to tests of one sand.
inline constexpr double kOfTheWay = 0.1;

/// The last part of shear (from 40 % of its strain or the largest η, whichever is later) in six
/// windows, each with its rate r = dε_v/dε_q (drained) or d ln p′/dε_q (undrained). Where r of the
/// last is none beyond its error the state is at rest: means of the last windows. Else η, ln p′ and
/// e are lines over r (stress against dilatancy), and the critical state is where r = 0, provided
/// that r was falling. The error holds that of the line, and a tenth of the way that was
/// extrapolated. What lies closer than 0.005 (e), 0.05 (ln p′) and 2 % of η counts as reached.
///
/// `stress_error_kPa`: of q and of p′, as zeros and calibrations have it, which no scatter within
/// the test shows; it is in the errors of η and ln p′.
CriticalState critical_state(const ShearCurve& curve, bool drained, double stress_error_kPa = 0);

}  // namespace triax::study
