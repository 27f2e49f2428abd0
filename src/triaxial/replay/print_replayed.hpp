// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "src/reference/reference_files.hpp"

namespace triax::src {

/// What a replay came to: the tests `ids` and then the results of AGS4 files, as text or as one
/// JSON document (an object for one test or file, an array for several). Nothing for none. With
/// `live` of the tests what was said while they ran.
void print_replayed(const std::string& db, const std::vector<std::int64_t>& ids,
                    const ReferenceFiles& references, bool json, bool live);

}  // namespace triax::src
