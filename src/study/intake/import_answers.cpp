// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/import_answers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/intake/names/lexicon.hpp"
#include "lab/intake/names/unit_names.hpp"
#include "lab/records/metadata.hpp"
#include "src/study/intake/value_questions.hpp"

namespace triax::study {
namespace {

using About = ImportQuestion::About;

/// Quantities with that name, with spaces or underscores, or that a whole heading names so.
std::vector<const lab::LexiconQuantity*> find_quantities_in_words(std::string_view text) {
  std::string name = lab::folded(text);
  std::ranges::replace(name, ' ', '_');
  if (const auto* quantity = lab::find_lexicon_quantity(name)) return {quantity};
  std::vector<const lab::LexiconQuantity*> out;
  for (const lab::NameCandidate& one : lab::find_names(text).candidates)
    if (one.how == lab::NameMatch::exact && is_of_record(one.quantity->name))
      out.push_back(one.quantity);
  return out;
}

std::string unknown_quantity(std::string_view text) {
  std::vector<std::string> names{kNotUsed, kTestColumn};
  for (const lab::LexiconQuantity& one : lab::lexicon_quantities())
    if (is_of_record(one.name)) names.push_back(one.name);
  return lab::invalid_value(text, names);
}

void set_quantity(ImportChoices& choices, ColumnChoice& column, const std::string& quantity) {
  column.is_quantity_answered = true;
  if (column.quantity == quantity) return;
  for (ColumnChoice& other : choices.columns)
    if (!quantity.empty() && other.quantity == quantity) {
      other.quantity.clear();
      other.unit.clear();
      other.is_quantity_answered = true;
    }
  const auto* known = lab::find_lexicon_quantity(quantity);
  const auto usual = known ? lab::unsaid_units(*known) : std::vector<std::string>();
  const bool keeps_unit =
      known &&
      std::ranges::any_of(lab::find_unit_names(column.unit), [&](const lab::UnitName* unit) {
        return lab::factor_to_canonical(*known, *unit).has_value();
      });
  column.quantity = quantity;
  column.sign = 1;
  column.factor = 1;
  column.note.clear();
  column.is_unit_answered = keeps_unit && !column.unit.empty();
  if (!keeps_unit) column.unit = usual.empty() ? "" : usual.front();
}

std::string answer_quantity(ImportChoices& choices, ColumnChoice& column, std::string_view text) {
  if (lab::folded(text) == kNotUsed) {
    set_quantity(choices, column, {});
    return {};
  }
  if (lab::folded(text) == kTestColumn) {
    set_quantity(choices, column, kTestColumn);
    return {};
  }
  const auto found = find_quantities_in_words(text);
  if (found.empty()) return unknown_quantity(text);
  if (found.size() > 1) {
    std::vector<std::string> names;
    names.reserve(found.size());
    for (const auto* one : found) {
      names.push_back(one->name);
      std::ranges::replace(names.back(), '_', ' ');
    }
    return fmt::format("{} can be: {}", lab::excerpt(text), lab::joined(names));
  }
  const std::string& name = found.front()->name;
  set_quantity(choices, column, is_of_record(name) ? name : std::string());
  return {};
}

std::string answer_unit(ColumnChoice& column, std::string_view text) {
  const auto* quantity = lab::find_lexicon_quantity(column.quantity);
  const auto fits = [&](const lab::UnitName* unit) {
    const auto conversion = lab::conversion_to_canonical(*quantity, *unit);
    return conversion && conversion->offset == 0 && conversion->power == 1;
  };
  if (!quantity || std::ranges::none_of(lab::find_unit_names(text), fits)) {
    const auto usual = quantity ? lab::unsaid_units(*quantity) : std::vector<std::string>();
    return fmt::format("{} is no unit of this column, for example {}", lab::excerpt(text),
                       lab::joined(usual));
  }
  column.unit = std::string(lab::trimmed(text));
  column.is_unit_answered = true;
  column.is_quantity_answered = true;  // the question names the quantity
  return {};
}

std::string answer_sign(ColumnChoice& column, std::string_view text) {
  if (text != "1" && text != "-1") return lab::invalid_value(text, {"1", "-1"});
  column.sign = text == "1" ? 1 : -1;
  column.is_sign_answered = true;
  return {};
}

std::string answer_date_order(ImportChoices& choices, std::string_view text) {
  const auto order = lab::find_date_order(lab::folded(text));
  if (!order) return lab::invalid_value(text, {"day first", "month first"});
  for (ColumnChoice& column : choices.columns)
    if (column.date_order) {
      column.date_order = order;
      column.is_unit_answered = true;
    }
  return {};
}

std::string answer_definitions(ImportChoices& choices, std::string_view text) {
  if (text != "p q" && text != "s t") return lab::invalid_value(text, {"p q", "s t"});
  constexpr std::array<std::array<const char*, 2>, 2> kPairs{
      {{"deviator_stress", "half_deviator_stress"},
       {"mean_effective_stress", "mean_effective_stress_2d"}}};
  const std::size_t wanted = text == "s t" ? 1 : 0;
  for (ColumnChoice& column : choices.columns)
    for (const auto& pair : kPairs) {
      if (column.quantity != pair[0] && column.quantity != pair[1]) continue;
      column.quantity = pair.at(wanted);
      column.is_quantity_answered = true;
    }
  return {};
}

std::string answer_programme(ImportChoices& choices, std::string_view text) {
  if (text == kDrained) {
    choices.set_constant("pore_pressure", 0, "kPa");
    return {};
  }
  if (text != "UU" && text != "UC") return lab::invalid_value(text, {"UU", "UC", kDrained});
  choices.programme = text;
  return {};
}

/// The fault of a value of this key; empty if there is none.
std::string fault_of(const std::string& key, double value) {
  lab::RecordHeader probe;
  try {
    lab::set_metadata(probe, "answer", key, fmt::format("{}", value));
  } catch (const lab::BadInput& error) {
    return error.what();
  }
  return {};
}

std::string answer_value(ImportChoices& choices, const std::string& key, double number) {
  const bool is_stress = key == "back_pressure" || key == kConsolidationStress;
  auto fault = fault_of(is_stress ? "test.cell_pressure_kPa" : key, number);
  if (!fault.empty()) return fault;
  if (key.starts_with("specimen.")) {
    choices.set_value(key, number);
    return {};
  }
  const std::string pore = second_pressure(choices);
  if (key != "back_pressure") choices.set_constant("cell_pressure", number, "kPa");
  if (key == "back_pressure") choices.set_constant(pore, number, "kPa");
  if (key == kConsolidationStress) choices.set_constant(pore, 0, "kPa");
  return {};
}

/// The readings become a force or a displacement.
std::string answer_factor(ImportChoices& choices, ColumnChoice& column, double number) {
  if (number == 0) return "0 is no factor";
  const bool is_force = column.quantity == "force_reading";
  set_quantity(choices, column, is_force ? "axial_force" : "axial_displacement");
  column.unit = is_force ? "N" : "mm";
  column.is_unit_answered = true;
  column.factor = std::fabs(number);
  column.sign = number < 0 ? -1 : 1;
  return {};
}

std::string answer_number(ImportChoices& choices, const ImportQuestion& question,
                          ColumnChoice* column, std::string_view answer) {
  const auto number = lab::whole_text_as<double>(lab::trimmed(answer));
  if (!number || !std::isfinite(*number))
    return fmt::format("{} is no number", lab::excerpt(answer));
  if (question.about == About::value) return answer_value(choices, question.key, *number);
  return column ? answer_factor(choices, *column, *number)
                : fmt::format("the table has no column {}", question.position);
}

}  // namespace

std::string give_answer(ImportChoices& choices, const ImportQuestion& question,
                        std::string_view answer) {
  ColumnChoice* column = choices.at(question.position);
  switch (question.about) {
    case About::date_order:
      return answer_date_order(choices, answer);
    case About::definitions:
      return answer_definitions(choices, answer);
    case About::programme:
      return answer_programme(choices, answer);
    case About::value:
    case About::factor:
      return answer_number(choices, question, column, answer);
    default:
      break;
  }
  if (!column) return fmt::format("the table has no column {}", question.position);
  if (question.about == About::quantity) return answer_quantity(choices, *column, answer);
  if (question.about == About::unit) return answer_unit(*column, answer);
  return answer_sign(*column, answer);
}

}  // namespace triax::study
