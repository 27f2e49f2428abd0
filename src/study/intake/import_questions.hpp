// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The questions that a table and the choices of the user leave open.
#include <vector>

#include "src/study/intake/import_choices.hpp"
#include "src/study/intake/import_question.hpp"

namespace triax::study {

/// Questions that are open with these choices, in the order in which they are asked. The columns of
/// a table without headings come first, each with the question for its quantity.
std::vector<ImportQuestion> open_questions(const lab::Proposal& proposal,
                                           const ImportChoices& choices);

}  // namespace triax::study
