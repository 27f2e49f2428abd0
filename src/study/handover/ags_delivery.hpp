// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests as one delivery of AGS4 4.1.1.
#include <string>
#include <vector>

#include "lab/ags/ags_document.hpp"
#include "src/study/handover/ags_references.hpp"
#include "src/study/handover/shear_values.hpp"

namespace triax::study {

struct AgsTest {
  db::StoredTest stored;
  ShearValues shear;
};

/// PROJ, TRAN, UNIT, TYPE, ABBR, DICT, LOCA and SAMP; TREG and TRET of tests with effective
/// stresses, TRIG and TRIT of those without consolidation, CTRG, CTRC, CTRP and CTRD of cyclic ones
/// (the last two where the logger counted cycles: CTRD has one row a cycle, its last reading, since
/// its key has room for no more). What a test does not know is empty. `date` is yyyy-mm-dd, of the
/// transmission. Throws lab::BadInput where the result would break a rule of the format: what was
/// said does not fit its heading.
lab::AgsDocument ags_delivery(const std::vector<AgsTest>& tests, const std::vector<AgsSaid>& said,
                              const std::string& date);

/// Rows of one test in its own groups (ags_triaxial_rows.cpp, ags_cyclic_rows.cpp).
void add_triaxial_rows(AgsRows& rows, const AgsTest& test, const AgsCells& keys);
void add_total_stress_rows(AgsRows& rows, const AgsTest& test, const AgsCells& keys);
void add_cyclic_rows(AgsRows& rows, const AgsTest& test, const AgsCells& keys);

/// "flow", "none", "not assessed".
std::string ags_kind(const db::StoredTest& test);
/// Empty: there was none, or its stress ratio is not known.
std::optional<double> eta_at_loss_of_control(const db::StoredTest& test);
/// "Simulated, not measured. ..." and how stresses were found: what every general row says.
std::string ags_remark(const db::StoredTest& test);

/// A number in the type that the heading has in its group; SI in, `unit_si` is what one unit is.
std::string ags_value(const std::string& heading, double si, double unit_si = 1);
std::string ags_value(const std::string& heading, std::optional<double> si, double unit_si = 1);

}  // namespace triax::study
