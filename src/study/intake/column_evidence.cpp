// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/column_evidence.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace triax::study {
namespace {

std::string name_evidence(const lab::ColumnReading& reading) {
  if (!reading.name) return "unit and readings";
  switch (*reading.name) {
    case lab::NameMatch::exact:
      return "name";
    case lab::NameMatch::borrowed:
      return "readings; the name is usually another quantity";
    default:
      return "part of the name";
  }
}

}  // namespace

std::string column_evidence(const lab::Proposal& proposal, std::size_t column) {
  constexpr double kMinEvidence = 2;
  const lab::ColumnReading& reading = proposal.meaning.columns[column].reading;
  std::string out = name_evidence(reading);
  for (const lab::HeldIdentity& held : proposal.meaning.identities) {
    const auto& names = held.identity->quantities;
    if (std::fabs(held.evidence) < kMinEvidence || names.size() < 2 ||
        std::ranges::find(names, reading.quantity->name) == names.end())
      continue;
    out += fmt::format("; {} ({:+.1f})", held.identity->text, held.evidence);
  }
  return out;
}

std::string choice_evidence(const lab::Proposal& proposal, const ColumnChoice& choice,
                            std::size_t column) {
  if (choice.quantity.empty()) return {};
  if (choice.is_quantity_answered || choice.is_unit_answered || choice.is_sign_answered)
    return choice.note.empty() ? "your answer" : choice.note;
  if (choice.factor != 1) return fmt::format("readings times {:g} {}", choice.factor, choice.unit);
  const lab::ColumnReading& reading = proposal.meaning.columns[column].reading;
  if (reading.quantity && reading.quantity->name == choice.quantity)
    return column_evidence(proposal, column);
  return "names or numbers of tests";
}

}  // namespace triax::study
