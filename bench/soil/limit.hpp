// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What could be known of a spoilt test by somebody who knows how specimens scatter.
#include <vector>

#include "bench/soil/campaign.hpp"
#include "lab/results/state.hpp"

namespace triax::bench {

/// An error beside the scatter of specimens.
struct SpoiltSize {
  double deviations = 0;  ///< the error in standard deviations of e, of M or of σ₁′ at failure
  int numbers = 1;        ///< of the relation that shows it: a level 1, a line 2
};

/// Of the states that are true. `own`: standard deviations of specimens, of e (with that of its
/// measurement) and, as a share, of M or of the strength. A load cell and a cell pressure are taken
/// at the largest η, by what they do to η, or to σ₁′ over σ₃′ in a set of Mohr and Coulomb.
struct OwnScatter {
  double void_ratio = 0, strength = 0;
};
SpoiltSize size_of(Spoilt spoilt, bool strength_set, const std::vector<lab::State>& truth,
                   const OwnScatter& own);

/// The chance that the best test names it, of n tests of which `alike` (itself with them) share the
/// relation. It knows the scatter, that it is normal and the form of the relation, and not its
/// numbers; it names one in `level` of clean campaigns:
///
///   P(|N(d, 1)| > z(1 − level/2n)),   d = size/√(1 + numbers/(alike − 1)),
///
/// and none where fewer than numbers + 2 are alike, since then each may be the odd one.
double could_be_named(const SpoiltSize& size, int n, int alike, double level = 0.05);

}  // namespace triax::bench
