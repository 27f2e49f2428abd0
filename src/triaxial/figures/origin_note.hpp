// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where what a figure shows comes from, written into the figure itself: a picture taken out of its
// report keeps its origin.
#include <string>

#include "src/plot/note.hpp"
#include "src/study/triaxial/tests_origin.hpp"

namespace triax::src {

/// "simulated: inl2/S28-general", with the names of the simulated tests where others are recorded;
/// empty where none is simulated.
std::string origin_note(const study::TestsOrigin& origin);

}  // namespace triax::src
