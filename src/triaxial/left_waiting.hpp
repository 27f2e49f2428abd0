// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::src {

/// Reports on standard error what a reader does not see in the database: tests that a killed
/// program left waiting beside it, and readings that are missing from it.
void tell_of_gaps(const std::string& db);

}  // namespace triax::src
