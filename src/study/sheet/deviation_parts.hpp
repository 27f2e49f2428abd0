// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Deviations that tests of effective and of total stresses have in common.
#include <string>
#include <vector>

#include "src/study/sheet/load_corrections.hpp"

namespace triax::study {

void add_origin_deviation(std::vector<std::string>& out, const db::StoredTest& test);
/// H/D of 1.8 to 2.5 (ASTM 2 to 2.5), a diameter of 34 mm or more. `part`: of ISO 17892.
void add_dimension_deviations(std::vector<std::string>& out, const lab::SpecimenInfo& specimen,
                              int part);
/// What drains and piston make of q_f, where the standards would correct it.
void add_load_deviations(std::vector<std::string>& out, const SheetValues& values,
                         const LoadCorrections& corrections);
/// The membrane that nobody took off, a sensor that failed.
void add_record_deviations(std::vector<std::string>& out, const db::StoredTest& test);

}  // namespace triax::study
