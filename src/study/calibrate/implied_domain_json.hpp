// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cones and domain of a calibrated set in its JSON document.
//
//   {"void_ratio", "of_collapsed_tests", "confidence", "draws", "asked", "refused",
//    "none": why no domain is told, or null,
//    "compression": [{"p_eff_kPa", "first_unstable", "alpha_deg", "isotropic_unloading",
//                     "limit"}], "extension": likewise,
//    "cones": [{"p_eff_kPa", "q_kPa", "eta", "from_deg", "to_deg", "opening_deg"}]}
//
// Criteria are stress ratios η; each number is {"value": of the best set, "low", "high": of the
// draws, "share": of the draws that have it}, null where it is not known.
#include "src/study/calibrate/implied_domain.hpp"
#include "src/study/json_parts.hpp"

namespace triax::study {

Json implied_domain_json(const ImpliedDomain& domain);

}  // namespace triax::study
