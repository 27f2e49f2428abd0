// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Codes of AGS4 and what they stand for, in our words.
#include <string>

#include "src/study/handover/shear_values.hpp"

namespace triax::study {

/// "CIUC", "CADE", ... of TREG_TYPE; "CSD" and "CSU" where q was held, which AGS4 has no code for;
/// of a cyclic test the code of CTRG_TYPE; empty where the record does not say how it was drained.
/// Isotropic is a |q| of less than 5 % of p' at the start of shear.
std::string ags_test_type(const db::StoredTest& test, const ShearValues& shear);

/// What the code below that heading means; empty where we do not know it.
std::string ags_code_meaning(const std::string& heading, const std::string& code);
std::string ags_unit_meaning(const std::string& unit);
std::string ags_type_meaning(const std::string& type);

}  // namespace triax::study
