// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "src/study/sheet/load_corrections.hpp"

namespace triax::study {

/// In which way the test is none of those of ISO 17892-9, ASTM D4767 and D7181 and BS 1377-8, one
/// of total stresses none of ISO 17892-8 and ASTM D2850: a sentence each.
std::vector<std::string> deviations_of(const db::StoredTest& test, const SheetValues& values,
                                       const SheetWords& words);

}  // namespace triax::study
