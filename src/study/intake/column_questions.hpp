// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Questions about one column of a table. Pre-condition of all: the table has a column at `position`
// (from 1).
#include <cstddef>
#include <optional>

#include "src/study/intake/import_choices.hpp"
#include "src/study/intake/import_question.hpp"

namespace triax::study {

/// Its quantity: the chosen one, those that the heading can name, and the common ones.
ImportQuestion quantity_question(const lab::Proposal& proposal, const ImportChoices& choices,
                                 std::size_t position);
/// Nothing for a quantity without units, and for clocks.
std::optional<ImportQuestion> unit_question(const lab::Proposal& proposal,
                                            const ImportChoices& choices, std::size_t position);
/// Nothing for quantities that have no sign: times, clocks, numbers of stages.
std::optional<ImportQuestion> sign_question(const ImportChoices& choices, std::size_t position);
/// N or mm per reading of a proving ring or a dial gauge; nothing for other columns.
std::optional<ImportQuestion> factor_question(const ImportChoices& choices, std::size_t position);
/// Day or month first. Pre-condition: the column has dates.
ImportQuestion date_order_question(const lab::Proposal& proposal, const ImportChoices& choices,
                                   std::size_t position);

}  // namespace triax::study
