// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where a specimen came from, in the client's own words.
#include <string>
#include <vector>

#include "db/store.hpp"
#include "src/study/handover/ags_cells.hpp"

namespace triax::study {

/// What --set says of a delivery: HEADING=VALUE, or TEST/HEADING=VALUE for one test.
struct AgsSaid {
  std::string test;     ///< name or number; empty: all
  std::string heading;  ///< "SAMP_REF"
  std::string value;    ///< as it will stand in the file
};

/// From KEY and VALUE. Throws lab::BadInput for a heading that the groups of a delivery do not
/// have.
AgsSaid ags_said(const std::string& key, const std::string& value);

/// Whether what was said is of that test.
bool is_of(const AgsSaid& said, const db::StoredTest& test);

/// The seven keys of a specimen (LOCA_ID, SAMP_TOP, SAMP_REF, SAMP_TYPE, SAMP_ID, SPEC_REF,
/// SPEC_DPTH), as they were said; else as the preamble of the record has them under these names or
/// under a logger's (Borehole, Sample Name, Depth, Test Number); SPEC_REF else the test's name. No
/// sign of them is changed, but that a depth in metres gets the two decimals of its type where that
/// is the same number.
AgsCells ags_references(const db::StoredTest& test, const std::vector<AgsSaid>& said);

/// The value as a cell of that type: a plain number gets the decimals that it lacks, nothing else
/// is changed.
std::string ags_cell(const std::string& value, const std::string& type);

}  // namespace triax::study
