// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_json.hpp"

#include <cmath>

#include "sim/mechanics/units.hpp"
#include "src/reference/reference_words.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::src {
namespace {

using study::Json;

Json in_unit(const std::optional<double>& si, const char* unit) {
  return si && std::isfinite(*si) ? Json(sim::to_field(*si, *sim::find_unit(unit))) : Json(nullptr);
}

Json reference_specimen_json(const lab::ReferenceResult& r) {
  const lab::ReferenceSpecimen& of = r.specimen;
  return {{"location", study::json_text(of.location)},
          {"sample_reference", study::json_text(of.sample_reference)},
          {"sample_type", study::json_text(of.sample_type)},
          {"sample_id", study::json_text(of.sample_id)},
          {"sample_top_m", study::json_number(of.sample_top_m)},
          {"specimen_reference", study::json_text(of.specimen_reference)},
          {"specimen_depth_m", study::json_number(of.specimen_depth_m)},
          {"diameter_mm", in_unit(r.diameter_m, "mm")},
          {"height_mm", in_unit(r.height_m, "mm")},
          {"initial_water_content_pct", in_unit(r.initial_water_content, "%")},
          {"final_water_content_pct", in_unit(r.final_water_content, "%")},
          {"bulk_density_Mg_m3", in_unit(r.bulk_density_kg_m3, "Mg/m3")},
          {"dry_density_Mg_m3", in_unit(r.dry_density_kg_m3, "Mg/m3")}};
}

Json failure_json(const lab::ReferenceResult& r) {
  return {{"cell_pressure_kPa", study::json_kPa(r.cell_pressure_pa)},
          {"pore_pressure_kPa", study::json_kPa(r.pore_pressure_pa)},
          {"q_kPa", study::json_kPa(r.q_pa)},
          {"p_eff_kPa", study::json_kPa(r.p_eff_pa())},
          {"s_eff_kPa", study::json_kPa(r.s_eff_pa())},
          {"t_kPa", study::json_kPa(r.t_pa())},
          {"axial_strain_pct", in_unit(r.axial_strain, "%")},
          {"volumetric_strain_pct", in_unit(r.volumetric_strain, "%")},
          {"undrained_strength_kPa", study::json_kPa(r.undrained_strength_pa)},
          {"mode", study::json_text(r.failure_mode)},
          {"criterion", study::json_text(r.failure_criterion)}};
}

Json reference_result_json(const lab::ReferenceResult& r) {
  return {{"group", r.group},
          {"line", r.line},
          {"test_type", study::json_text(r.test_type)},
          {"condition", study::json_text(r.condition)},
          {"stage", study::json_text(r.stage)},
          {"specimen", reference_specimen_json(r)},
          {"b_value", study::json_number(r.b_value)},
          {"back_pressure_kPa", study::json_kPa(r.back_pressure_pa)},
          {"consolidation_pressure_kPa", study::json_kPa(r.consolidation_pressure_pa)},
          {"initial_pore_pressure_kPa", study::json_kPa(r.initial_pore_pressure_pa)},
          {"at_failure", failure_json(r)},
          {"cohesion_kPa", study::json_kPa(r.cohesion_pa)},
          {"friction_angle_deg", in_unit(r.friction_angle_rad, "deg")},
          {"remarks", study::json_text(r.remarks)}};
}

}  // namespace

Json reference_json(const lab::AgsResults& file) {
  Json results = Json::array(), warnings = Json::array();
  for (const auto& result : file.results) results.push_back(reference_result_json(result));
  for (const auto& warning : file.warnings) warnings.push_back(study::in_words(warning));
  return {{"source", file.file},
          {"what", what_it_is(file)},
          {"edition", study::json_text(file.edition)},
          {"project", study::json_text(file.project)},
          {"readings", 0},
          {"reference_results", std::move(results)},
          {"warnings", std::move(warnings)}};
}

}  // namespace triax::src
