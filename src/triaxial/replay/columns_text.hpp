// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/intake/import_choices.hpp"

namespace triax::src {

/// A table with heading, first values, quantity, unit, sign and evidence of each column, then the
/// constants and values. Pre-condition: `choices` are of this proposal.
std::string columns_text(const lab::Proposal& proposal, const study::ImportChoices& choices);

}  // namespace triax::src
