// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>

#include "lab/intake/proposal.hpp"
#include "src/study/intake/import_choices.hpp"

namespace triax::study {

/// Why a column is read as it is: "name; p′ = σ3′ + q/3 (+7.7)". Relations that count little are
/// left out. Pre-condition: the column is used, `column` is below the number of columns.
std::string column_evidence(const lab::Proposal& proposal, std::size_t column);

/// The same for the choice of that column, or "your answer" if the user decided it: its note, if it
/// has one. Empty if the column is not used.
std::string choice_evidence(const lab::Proposal& proposal, const ColumnChoice& choice,
                            std::size_t column);

}  // namespace triax::study
