// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers that a file may lack: dimensions of the specimen, held pressures, strength.
#include <array>
#include <span>
#include <string_view>

#include "src/study/intake/import_choices.hpp"
#include "src/study/intake/import_question.hpp"

namespace triax::study {

struct AskedValue {
  std::string_view key;   ///< of --set, or "back_pressure", which is a constant of the dialect
  std::string_view name;  ///< of lab::TableQuestion; with underscores that of a label
  std::string_view text;  ///< "height of the specimen"
  std::string_view unit;  ///< of the number: "mm"
  std::array<double, 4> usual;   ///< to offer
  std::string_view explanation;  ///< why it is asked; empty: it never is
  /// The label that is above the table, null if there is none.
  const lab::LabelValue* label(const lab::Proposal& proposal) const;
};

/// Effective consolidation stress: given as cell pressure and back pressure.
inline constexpr std::string_view kConsolidationStress = "effective_consolidation_stress";

std::span<const AskedValue> asked_values();

/// The question for the value with that name. Pre-condition: one of asked_values() has it.
ImportQuestion value_question(const lab::Proposal& proposal, const ImportChoices& choices,
                              std::string_view name);

/// True if the record needs the value with that name, although a label or other columns seem to
/// make up for it. For cell pressure, height and diameter.
bool is_value_open(const lab::Proposal& proposal, const ImportChoices& choices,
                   std::string_view name);

}  // namespace triax::study
