// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>

#include "lab/collapse/stress_span.hpp"
#include "lab/measured/path_rates.hpp"

namespace triax::lab {

/// What turns at an onset.
enum class Witness {
  /// dq dε_q + dp′ dε_v, which turns negative.
  second_order_work,
  /// dp′ dε_v: second-order work while q is held.
  volume,
  /// dp′ du: at held q with the valve closed C du = V dε_v, so that it has the sign of dp′ dε_v.
  pore_pressure,
};

struct OnsetFit {
  PathPoint point;            ///< values of the path at the onset; its rates are those of the fit
  double error = 0;           ///< standard error of point.reading
  double stress_scatter = 0;  ///< variance of a block's (p', q) as a vector about the cubics, Pa²
};

/// Where the witness turns from positive to negative: the root of the witness built from the
/// derivatives of cubics through the signals, least squares over all of the blocks. The scatter
/// about the cubics, with its correlation from block to block, gives the error: δt = δW/|dW/dt|.
/// Empty if there are fewer than 32 blocks, or no such root but at the edge of them (outside the
/// middle nine tenths). The root nearest to `near_reading` counts.
std::optional<OnsetFit> fit_onset(std::span<const PathSample> blocks, Witness witness,
                                  double near_reading);

/// Stresses at a reading from cubics, Pa, and their standard errors from the scatter about them.
struct StressFit {
  double q = 0, p_eff = 0;
  StressError error;
  double pore_pressure = 0;
  double p_rate = 0, pore_rate = 0;        ///< a reading
  double q_scatter = 0, pore_scatter = 0;  ///< standard deviation of a block about the cubic
};
/// Pre-condition: at least eight blocks, the reading among them.
StressFit stress_at(std::span<const PathSample> blocks, double reading);

/// Values of the path at a reading from cubics through the blocks around it. Pre-condition: at
/// least five blocks, the reading among them.
PathPoint values_at(std::span<const PathSample> blocks, double reading);

}  // namespace triax::lab
