// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace triax::src {

/// Of the named tests what was said while they ran, as text or as one JSON document (an object for
/// one test, an array for several).
std::string live_document(const std::string& db, const std::vector<std::int64_t>& ids, bool json);

}  // namespace triax::src
