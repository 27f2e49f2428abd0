// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/ags/triaxial_results.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {

/// The results of a file as one object: units in the names, what is unknown is null.
study::Json reference_json(const lab::AgsResults& file);

}  // namespace triax::src
