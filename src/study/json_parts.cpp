// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/json_parts.hpp"

#include <cmath>

#include "sim/mechanics/axisymmetric.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::study {

Json json_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json json_kPa(const std::optional<double>& pa) {
  static const sim::Unit kPa = *sim::find_unit("kPa");
  return pa && std::isfinite(*pa) ? Json(sim::to_field(*pa, kPa)) : Json(nullptr);
}

Json json_deg(const std::optional<double>& rad) {
  return json_number(rad ? std::optional(sim::degrees(*rad)) : std::nullopt);
}

Json json_text(const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); }

Json json_material(const lab::MaterialSet& material) {
  return {{"name", material.name},
          {"law", material.law->name},
          {"based_on", json_text(material.material.based_on)},
          {"description", json_text(material.description)},
          {"source", json_text(material.source)},
          {"range", json_text(material.range)}};
}

std::string json_document(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string json_line(const Json& document) {
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace triax::study
