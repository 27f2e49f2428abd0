// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A loop that holds q searches for it: the specimen follows increments that nobody asked for, and
// while their second-order work is the larger one nobody can say where that of the trend turned.
#include "lab/measured/path_history.hpp"

namespace triax::lab {

/// dε_v/d ln p′ of sand that is unloaded, at most: K is at least 330 p′.
inline constexpr double kSwelling = 0.003;

/// δq²/(3G) K/p′ of the largest increment from one reading to the next of a q that scatters by
/// `q_scatter`, δq = 2.2 √2 s_q, with 3G = 1.5 K; Pa.
double work_of_search(double q_scatter, double p_eff);

/// Where a stage began, Pa.
struct StageStart {
  double q = 0, p_eff = 0, pore_pressure = 0;
};

/// The last reading of a stretch after the turn of the volume at held q, valve closed, in which
/// nobody can say whose increments the specimen follows: those of the slow trend, or those of the
/// loop that seeks q. It ends, at `last` at the latest, where the second-order work of the trend is
/// larger than that of a search as large as q scatters,
///   −dp′ dε_v > δq²/(3G),  dε_v = c du,  δq = 2.2 √2 s_q,
/// a reading each. The compliance c of what is shut in follows from the swelling so far, K the bulk
/// modulus: c (u₀ − u) = ln(p′₀/p′) p′/K; with 3G = 1.5 K no modulus is left. Where u
/// has not fallen by what its scatter lets be told, the search is the stronger up to `last`.
double end_of_search(const PathHistory& history, const StageStart& start, double turn, double last);

}  // namespace triax::lab
