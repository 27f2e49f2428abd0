// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::src {

/// A sentence for the user on standard error while work goes on, a line of its own; the same one is
/// not said twice in a row. From any thread.
void notify(const std::string& sentence);

}  // namespace triax::src
