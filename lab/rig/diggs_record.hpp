// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Records that lie in a DIGGS file, which may hold several tests.
#include <memory>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/records/findings.hpp"
#include "lab/rig/recorded.hpp"

namespace triax::lab {

/// The source itself where it is no DIGGS; else the record of test options.test. Throws BadInput
/// where the file cannot be read, holds several tests and none is chosen, or a dialect or a
/// worksheet is given.
std::unique_ptr<ByteSource> diggs_or_other(std::unique_ptr<ByteSource> source,
                                           const RecordOptions& options);

/// Notes and warnings of a record that came from diggs_or_other(); nothing for another source.
void take_diggs_notes(RecordHeader& header, ByteSource& source, Findings& findings);

/// Removes the lines of warnings that count lines of the converted text, not of the DIGGS file.
void remove_text_lines(std::vector<Warning>& warnings, ByteSource& source);

}  // namespace triax::lab
