// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/collapse/stress_span.hpp"
#include "lab/measured/path_history.hpp"

namespace triax::lab {

/// An onset that windows of single readings placed on the largest |q|: the vertex of the parabola
/// through that reading and its two neighbours, with p′, strains and u of parabolas, too. As it is
/// where windows are longer, or where the reading is not larger than its neighbours.
PathPoint peak_of_readings(PathPoint onset, const PathHistory& history);

/// The interval of an onset that lies between two readings, with 95 %; numbers need not be whole.
/// The path there is what cubics through twelve readings on either side give, more where the
/// history knows it in blocks only; the readings
/// themselves where `single` says that noise is small beside what the path does from one to the
/// next. Empty where the history does not know that part of the path.
std::optional<StressInterval> interval_over(const PathHistory& history, const PathPoint& onset,
                                            double low, double high, bool single);

}  // namespace triax::lab
