// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a browser is told while a test runs, as Server-Sent Events.
#include <string>

#include "src/page/live/live_feed.hpp"

namespace triax::src {

/// Each item as an event with its position as id; "window" for what was missed, "progress" for the
/// share done. Readings have the columns of db::read_columns(), to the bit as the database gives
/// them, and the time of the clock at which they were told (ms since 1970).
std::string live_frames(const LiveTaken& taken);

}  // namespace triax::src
