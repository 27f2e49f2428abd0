// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_json.hpp"

#include <fmt/format.h>

#include "sim/stability/domain_criteria.hpp"
#include "src/study/json_parts.hpp"

namespace triax::study {
namespace {

/// "KEY": [ one element a line ]
std::string lines(const char* key, const std::vector<std::string>& elements) {
  std::string out = fmt::format("  \"{}\": [", key);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    out += i > 0 ? ",\n    " : "\n    ";
    out += elements[i];
  }
  return out + (elements.empty() ? "]" : "\n  ]");
}

Json refused_json(const ReportedDomain& domain) {
  Json out = {{"states", 0}, {"p_eff_kPa", nullptr}, {"reason", nullptr}};
  int count = 0;
  for (const ReportedColumn& column : domain.columns) {
    for (const ReportedDomainState& state : column.states)
      count += state.kind == sim::DomainStateKind::refused;
    if (column.refusal.empty() || !out["reason"].is_null()) continue;
    out["p_eff_kPa"] = column.p_eff_kPa;
    out["reason"] = column.refusal;
  }
  out["states"] = count;
  return out;
}

}  // namespace

std::string dumped(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json material_json(const DomainSettings::Material& m) {
  Json parameters = Json::object();
  for (const auto& [key, value] : m.parameters) parameters[key] = value;
  Json files = Json::object();
  for (const auto& [key, value] : m.files) files[key] = value;
  return {{"name", m.name},
          {"law", m.law},
          {"based_on", json_text(m.based_on)},
          {"description", json_text(m.description)},
          {"source", json_text(m.source)},
          {"range", json_text(m.range)},
          {"parameters", std::move(parameters)},
          {"files", std::move(files)}};
}

Json grid_json(const DomainSettings::Grid& g) {
  Json out = {{"p_from_kPa", g.p_from_kPa}, {"p_to_kPa", g.p_to_kPa}, {"columns", g.columns},
              {"q_from_kPa", g.q_from_kPa}, {"q_to_kPa", g.q_to_kPa}, {"rows", g.rows},
              {"void_ratio", g.void_ratio}, {"plane", g.plane},       {"directions", g.directions}};
  for (const auto& kind : sim::domain_criterion_kinds())
    out[std::string(kind.name)] = g.looks_for(kind.name);
  return out;
}

Json mark_json(const std::optional<DomainMark>& mark) {
  if (!mark) return nullptr;
  return {{"q_kPa", mark->q_kPa}, {"eta", mark->eta}, {"alpha_deg", json_number(mark->alpha_deg)}};
}

Json boundary_json(const ReportedBoundary& boundary) {
  Json out = Json::object();
  for (const std::string& key : boundary_keys()) out[key] = mark_json(boundary.mark(key));
  return out;
}

Json state_json(const ReportedDomainState& state) {
  Json cones = Json::array();
  for (const auto& [from, to] : state.cones_deg)
    cones.push_back({{"from_deg", from}, {"to_deg", to}});
  return {{"q_kPa", state.q_kPa},
          {"kind", word_of(state.kind)},
          {"w2_normalised_least", json_number(state.least_work)},
          {"alpha_deg", json_number(state.least_angle_deg)},
          {"cones", std::move(cones)},
          {"refused_directions", state.refused_directions}};
}

std::string domain_json(const ReportedDomain& domain) {
  std::vector<std::string> boundaries, states;
  for (const ReportedColumn& column : domain.columns) {
    for (const bool extension : {false, true}) {
      Json one = {{"p_eff_kPa", column.p_eff_kPa},
                  {"side", extension ? "extension" : "compression"}};
      one.update(boundary_json(extension ? column.extension : column.compression));
      boundaries.push_back(dumped(one));
    }
    for (const ReportedDomainState& state : column.states) {
      Json one = {{"p_eff_kPa", column.p_eff_kPa}};
      one.update(state_json(state));
      states.push_back(dumped(one));
    }
  }
  const DomainSettings& settings = domain.settings;
  return fmt::format(
      "{{\n  \"origin\": \"simulated\",\n  \"material\": {},\n  \"grid\": {},\n  \"warnings\": "
      "{},\n  \"refused\": {},\n{},\n{}\n}}\n",
      dumped(material_json(settings.material)), dumped(grid_json(settings.grid)),
      dumped(Json(settings.warnings)), dumped(refused_json(domain)),
      lines("boundaries", boundaries), lines("states", states));
}

}  // namespace triax::study
