// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "src/study/json_parts.hpp"
#include "src/study/triaxial/live_account.hpp"

namespace triax::src {

/// The document of a test (json_report.hpp) with, as `live`, what was said when.
study::Json live_json(const db::Store& store, std::int64_t id);

}  // namespace triax::src
