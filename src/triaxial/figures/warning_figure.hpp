// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/warning_history.hpp"

namespace triax::src {

/// η as measured and as it was forecast for the onset, with the 90 % interval as a band; q below;
/// lines where the alarm spoke, where the onset was found and where the specimen's own was.
Drawing warning_figure(const study::WarningHistory& history);

}  // namespace triax::src
