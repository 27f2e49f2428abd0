// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A proposal for a table as text.
#include <string>
#include <vector>

#include "lab/intake/proposal.hpp"
#include "src/study/intake/import_choices.hpp"

namespace triax::src {

/// The meaning of each column in canonical units (s, mm, mm2, mm3, kN, kPa, degC and
/// plain numbers), for comparison with a known meaning. All blocks of the file.
std::string meaning_text(const std::vector<lab::Proposal>& proposals, const std::string& file,
                         const std::string& encoding);

}  // namespace triax::src
