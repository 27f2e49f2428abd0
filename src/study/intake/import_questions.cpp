// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/import_questions.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "lab/intake/questions.hpp"
#include "src/study/intake/column_questions.hpp"
#include "src/study/intake/value_questions.hpp"

namespace triax::study {
namespace {

using About = ImportQuestion::About;

ImportQuestion definitions_question(const lab::Proposal& proposal) {
  const bool is_plane =
      proposal.has("half_deviator_stress") || proposal.has("mean_effective_stress_2d");
  return {.about = About::definitions,
          .text = "definition of the stresses",
          .explanation =
              "The headings of a mean effective stress and a deviator stress are used for both "
              "definitions. The friction angle depends on the answer by 7 to 22 degrees.",
          .answers = {{"p q", "p' = (σ1' + 2 σ3')/3, q = σ1 − σ3"},
                      {"s t", "s' = (σ1' + σ3')/2, t = (σ1 − σ3)/2"}},
          .usual = is_plane ? "s t" : "p q"};
}

/// Asks for a table without pore pressure, effective stresses and volume.
ImportQuestion programme_question() {
  return {.about = About::programme,
          .text = "kind of test",
          .explanation =
              "The file has no pore pressure, no effective stress and no volume. The "
              "result of a test in total stresses is c_u.",
          .answers = {{"UU", "unconsolidated undrained, in total stresses"},
                      {"UC", "unconfined compression"},
                      {kDrained, "drained, pore pressure 0"}},
          .usual = "UU"};
}

bool is_programme_open(const lab::Proposal& proposal, const ImportChoices& choices) {
  return !proposal.type && choices.programme.empty() && !choices.has_toml_preamble &&
         !choices.constant("pore_pressure") && !choices.constant("back_pressure") &&
         !proposal.label("back_pressure") && lab::is_without_pore_pressure(proposal);
}

/// Without a usual answer if several units are equally usual, and results in a wrong one are
/// impossible: kN or N, mm³ or cm³.
std::optional<ImportQuestion> open_unit_question(const lab::Proposal& proposal,
                                                 const ImportChoices& choices,
                                                 std::size_t position) {
  constexpr std::array kOpen{"force", "volume", "area"};
  auto out = unit_question(proposal, choices, position);
  const auto column = std::ranges::find(choices.columns, position, &ColumnChoice::position);
  if (!out || column == choices.columns.end()) return out;
  const auto* const quantity = lab::find_lexicon_quantity(column->quantity);
  if (quantity && std::ranges::find(kOpen, quantity->dimension) != kOpen.end()) out->usual.clear();
  return out;
}

std::optional<ImportQuestion> question_for(const lab::Proposal& proposal,
                                           const ImportChoices& choices,
                                           const lab::TableQuestion& question) {
  const std::size_t column = question.position;
  switch (question.about) {
    case lab::TableQuestion::About::unit:
      if (auto factor = factor_question(choices, column)) return factor;
      return open_unit_question(proposal, choices, column);
    case lab::TableQuestion::About::sign:
      return sign_question(choices, column);
    case lab::TableQuestion::About::meaning:
      return quantity_question(proposal, choices, column);
    case lab::TableQuestion::About::definitions:
      return definitions_question(proposal);
    case lab::TableQuestion::About::date_order:
      return date_order_question(proposal, choices, column);
    case lab::TableQuestion::About::value:
      return value_question(proposal, choices, question.text);
    case lab::TableQuestion::About::headings:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::vector<ImportQuestion> open_questions(const lab::Proposal& proposal,
                                           const ImportChoices& choices) {
  const lab::Proposal chosen = apply_choices(proposal, choices);
  std::vector<ImportQuestion> out;
  const auto is_headings = [](const lab::TableQuestion& one) {
    return one.about == lab::TableQuestion::About::headings;
  };
  if (std::ranges::any_of(chosen.questions, is_headings)) {
    for (const ColumnChoice& column : choices.columns)
      if (!column.is_quantity_answered)
        out.push_back(quantity_question(proposal, choices, column.position));
    return out;
  }
  for (const lab::TableQuestion& question : chosen.questions)
    if (auto one = question_for(chosen, choices, question)) out.push_back(std::move(*one));
  for (const char* name : {"cell pressure", "height", "diameter"})
    if (is_value_open(chosen, choices, name) &&
        std::ranges::none_of(chosen.questions,
                             [&](const lab::TableQuestion& one) { return one.text == name; }))
      out.push_back(value_question(chosen, choices, name));
  if (is_programme_open(chosen, choices)) out.push_back(programme_question());
  return out;
}

}  // namespace triax::study
