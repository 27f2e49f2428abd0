// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <optional>

#include "lab/collapse/onset_fit.hpp"
#include "lab/collapse/stress_span.hpp"
#include "lab/measured/path_history.hpp"

namespace triax::lab {

/// An onset that windows of single readings placed on the largest |q|: the vertex of the parabola
/// through that reading and its two neighbours, with p′, strains and u of parabolas, too. As it is
/// where windows are longer, or where the reading is not larger than its neighbours.
PathPoint peak_of_readings(PathPoint onset, const PathHistory& history);

/// Readings between which an onset lies; numbers need not be whole.
struct Stretch {
  double low = 0, high = 0;
  /// The last reading of the path: what follows is a fall, which no curve follows.
  double until = std::numeric_limits<double>::infinity();
};

/// The interval of an onset that lies on a stretch of the path, with 95 %. The path there is what
/// cubics through twelve readings on either side give, more where the history knows it in blocks
/// only; the readings themselves where `single` says that noise is small beside what the path does
/// from one to the next. Single readings hide a peak of |q| between two of them: a concave path
/// lies below the lines through the two readings before and the two after, and their crossing is
/// the most that it may have been. Empty where the history does not know that part of the path.
std::optional<StressInterval> interval_over(const PathHistory& history, const PathPoint& onset,
                                            const Stretch& stretch, bool single);

/// Of an onset that a fit placed, `last` the last reading of the path before a fall.
std::optional<StressInterval> interval_of_fit(const PathHistory& history, const OnsetFit& fit,
                                              const PathPoint& onset, double last);

/// The interval of the one widened to hold the other. Pre-condition: both have q and p′.
void reach(Instant& onset, const Instant& other);

/// The state at a reading from a cubic through those around it up to `last`, more of them where the
/// path is known in blocks only.
std::optional<StressFit> stress_near(const PathHistory& history, double reading, double last);

}  // namespace triax::lab
