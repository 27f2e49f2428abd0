// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests with their readings as one document of DIGGS 2.6.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "db/store.hpp"
#include "src/study/handover/ags_references.hpp"

namespace triax::study {

/// From KEY and VALUE of --set, under the names of AGS4: PROJ_NAME, PROJ_CLNT, LOCA_ID, SAMP_REF,
/// SAMP_TOP, SPEC_REF. Throws lab::BadInput for another key.
AgsSaid diggs_said(const std::string& key, const std::string& value);

/// Writes project, locations and tests. A test has its readings as a table of results in the units
/// of their headings, so that they are read back bit for bit, and its shear as shearingIncrement
/// where the pore pressure is known, which the schema asks for. What DIGGS has no element for is
/// in otherTestProperty: results of the assessment, and metadata of triax under names that begin
/// with lab::kDiggsKeyPrefix. `date` is yyyy-mm-dd. `write` gets the text in pieces.
void write_diggs(const db::Store& store, const std::vector<db::StoredTest>& tests,
                 const std::vector<AgsSaid>& said, const std::string& date,
                 const std::function<void(std::string_view)>& write);

}  // namespace triax::study
