// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/element/material_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/output/table.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {
namespace {

using study::Json;

Json ends(const std::optional<lab::ValidRange>& range) {
  return range ? Json::array({range->low, range->high}) : Json(nullptr);
}

Json law_head(const sim::LawDescription& law) {
  return {{"name", law.name},
          {"title", law.title},
          {"source", study::json_text(law.source)},
          {"refuses", study::json_text(law.refuses)}};
}

const char* word_of(sim::ParameterKind kind) {
  switch (kind) {
    case sim::ParameterKind::number:
      return "number";
    case sim::ParameterKind::text:
      return "text";
    case sim::ParameterKind::numbers:
      break;
  }
  return "numbers";
}

/// The value that the set gives; what the law takes where it gives none; null where there is none.
Json value_of(const sim::ParameterDescription& parameter, const sim::ParameterSet& set) {
  if (const auto at = set.numbers.find(parameter.key); at != set.numbers.end()) return at->second;
  if (const auto at = set.texts.find(parameter.key); at != set.texts.end()) return at->second;
  if (const auto at = set.lists.find(parameter.key); at != set.lists.end()) return at->second;
  return parameter.usual ? Json(*parameter.usual) : Json(nullptr);
}

/// Empty for what is no number: a range says nothing of it.
std::string range_of(const sim::ParameterDescription& parameter) {
  return parameter.kind == sim::ParameterKind::number ? parameter.range.words() : std::string();
}

Json parameter_json(const sim::ParameterDescription& parameter) {
  return {{"key", parameter.key},
          {"symbol", study::json_text(parameter.symbol)},
          {"unit", study::json_text(parameter.unit)},
          {"meaning", parameter.meaning},
          {"range", study::json_text(range_of(parameter))},
          {"kind", word_of(parameter.kind)},
          {"usual", parameter.usual ? Json(*parameter.usual) : Json(nullptr)}};
}

std::string short_value(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) return fmt::format("{} numbers", value.size());
  return fmt::format("{:.7g}", value.get<double>());
}

/// A heading underlined and labelled lines below it; empty ones are left out.
std::string head(const std::string& title,
                 const std::vector<std::pair<std::string, std::string>>& facts) {
  const std::string line = on_one_line(title);
  std::string out = line + '\n' + std::string(display_width(line), '=') + '\n';
  for (const auto& [label, value] : facts)
    if (!value.empty()) out += fmt::format("  {:<12}{}\n", label, on_one_line(value));
  return out + '\n';
}

Table parameter_table(const sim::LawDescription& law, const sim::ParameterSet* set) {
  Table table;
  table.columns = {{"parameter", Align::left}, {"symbol", Align::left}};
  if (set != nullptr) table.columns.push_back({"value", Align::right});
  for (const char* heading : {"unit", "range", "meaning"})
    table.columns.push_back({heading, Align::left});
  for (const auto& parameter : law.parameters) {
    std::vector<std::string> row = {parameter.key, parameter.symbol};
    if (set != nullptr) row.push_back(short_value(value_of(parameter, *set)));
    row.insert(row.end(), {parameter.unit, range_of(parameter), parameter.meaning});
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::string materials_text(const std::vector<lab::MaterialSet>& sets) {
  std::string out;
  for (const auto& law : sim::laws()) {
    if (!out.empty()) out += '\n';
    out += fmt::format("{}: {} ({})\n", law.name, law.title, law.source);
    if (!law.refuses.empty()) out += fmt::format("  refuses {}\n", law.refuses);
    for (const auto& set : sets)
      if (set.law == &law)
        out += fmt::format("  {}\n      {}\n      range: {}\n      source: {}\n", set.name,
                           set.description, set.range, set.source);
  }
  return without_controls(out);
}

std::string materials_json(const std::vector<lab::MaterialSet>& sets) {
  Json document = Json::array();
  for (const auto& law : sim::laws()) {
    Json one = law_head(law);
    one["sets"] = Json::array();
    for (const auto& set : sets)
      if (set.law == &law)
        one["sets"].push_back({{"name", set.name},
                               {"description", study::json_text(set.description)},
                               {"range", study::json_text(set.range)},
                               {"void_ratio_range", ends(set.void_ratio_range)},
                               {"p_eff_range_kPa", ends(set.p_eff_range_kPa)},
                               {"source", study::json_text(set.source)}});
    document.push_back(std::move(one));
  }
  return study::json_document(document);
}

std::string material_text(const lab::MaterialSet& set) {
  return without_controls(head(set.name, {{"what", set.description},
                                          {"based on", set.material.based_on},
                                          {"range", set.range},
                                          {"source", set.source},
                                          {"law", set.law->title},
                                          {"equations", set.law->source},
                                          {"refuses", set.law->refuses},
                                          {"tensor", set.material.no_tensor}}) +
                          to_text(parameter_table(*set.law, &set.parameters)));
}

std::string material_json(const lab::MaterialSet& set) {
  Json document = {{"name", set.name},
                   {"law", law_head(*set.law)},
                   {"based_on", study::json_text(set.material.based_on)},
                   {"description", study::json_text(set.description)},
                   {"range", study::json_text(set.range)},
                   {"void_ratio_range", ends(set.void_ratio_range)},
                   {"p_eff_range_kPa", ends(set.p_eff_range_kPa)},
                   {"source", study::json_text(set.source)},
                   {"no_tensor_form", study::json_text(set.material.no_tensor)}};
  Json parameters = Json::array();
  for (const auto& parameter : set.law->parameters) {
    Json one = parameter_json(parameter);
    one["value"] = value_of(parameter, set.parameters);
    parameters.push_back(std::move(one));
  }
  document["parameters"] = std::move(parameters);
  return study::json_document(document);
}

std::string law_text(const sim::LawDescription& law) {
  return without_controls(
      head(law.name, {{"law", law.title}, {"equations", law.source}, {"refuses", law.refuses}}) +
      to_text(parameter_table(law, nullptr)));
}

std::string law_json(const sim::LawDescription& law) {
  Json document = law_head(law);
  Json parameters = Json::array();
  for (const auto& parameter : law.parameters) parameters.push_back(parameter_json(parameter));
  document["parameters"] = std::move(parameters);
  return study::json_document(document);
}

}  // namespace triax::src
