// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The results of triaxial tests in an AGS4 file: TREG with TRET (effective stress) and TRIG with
// TRIT (total stress). AGS4 has no group for the readings of such tests.
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/reference_result.hpp"

namespace triax::lab {

struct AgsResults {
  std::string file;
  std::string edition;  ///< "4.1.1"; empty where group TRAN does not say
  std::string project;  ///< name, or else id
  std::vector<ReferenceResult> results;
  std::vector<Warning> warnings;  ///< what was assumed or left out
};

/// Every row of TRET and TRIT with what TREG and TRIG say of its specimen, in the order of the
/// file; then the rows of TREG and TRIG that have none. Rows belong together by the seven keys of
/// AGS4, where a blank key fits any if only one specimen fits. Holds the triaxial rows, not the
/// file. Throws BadInput as AgsReader does, on units that do not fit, and where there is no
/// triaxial result.
AgsResults read_triaxial_results(ByteSource& source);

}  // namespace triax::lab
