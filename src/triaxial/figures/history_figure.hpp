// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/history.hpp"

namespace triax::src {

/// The curves of a history and below them its normalised second-order work, one above the other on
/// one common axis, with the onset of collapse marked through all of them. Pre-condition: the
/// history has a curve or work, as study::history() gives it.
Drawing history_figure(const study::History& history);

}  // namespace triax::src
