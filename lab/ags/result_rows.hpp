// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One row of a triaxial group of AGS4 as a result. The headings of TREG and TRIG, and those of TRET
// and TRIT, have the same endings, but for the length of the specimen.
#include "lab/ags/ags_number.hpp"
#include "lab/ags/ags_reader.hpp"
#include "lab/results/reference_result.hpp"

namespace triax::lab {

/// The reader's current row of TREG or TRIG. Throws BadInput as AgsNumbers does.
ReferenceResult general_row(const AgsReader& reader, AgsNumbers& numbers);
/// The same of TRET or TRIT.
ReferenceResult result_row(const AgsReader& reader, AgsNumbers& numbers);
/// Adds to a result what the row about its specimen says.
void add_general(ReferenceResult& result, const ReferenceResult& general);

}  // namespace triax::lab
