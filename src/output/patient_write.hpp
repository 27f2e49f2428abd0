// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

namespace triax::src {

/// Calls `write` until the disk has room for what it writes (lab::NoRoom), and says so on standard
/// error when that takes a while and when it is over: for files of a long run that cannot be had
/// again. Throws what else `write` throws, and NoRoom once `stop` answers true.
void write_when_there_is_room(const std::function<void()>& write,
                              const std::function<bool()>& stop);

}  // namespace triax::src
