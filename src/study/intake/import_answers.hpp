// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "src/study/intake/import_choices.hpp"
#include "src/study/intake/import_question.hpp"

namespace triax::study {

/// Changes the choices by an answer: the value of one of the answers, or another value of the same
/// kind (any quantity by its name or usual heading, any unit of the quantity). Gives what is wrong
/// with it, and changes nothing, if it is not valid; an empty text otherwise. A quantity that
/// another column has moves to this column.
std::string give_answer(ImportChoices& choices, const ImportQuestion& question,
                        std::string_view answer);

}  // namespace triax::study
