// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A proposal for a table (lab/intake/proposal.hpp) as a dialect to write.
#include <string>

#include "src/study/intake/import_choices.hpp"

namespace triax::study {

/// The complete dialect with the evidence for each column, unused columns, values above the table
/// and questions as comments. A unit that is asked is "?", which no dialect accepts. `file` is the
/// name of the file.
WrittenDialect proposed_dialect(const lab::Proposal& proposal, const std::string& file,
                                const ImportSource& source);

}  // namespace triax::study
