// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::src {

/// Tells on standard error of tests that a killed program left waiting beside the database, which
/// a reader does not see in it.
void tell_of_what_waits(const std::string& db);

}  // namespace triax::src
