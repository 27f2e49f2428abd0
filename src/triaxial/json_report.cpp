// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/json_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/mechanics/axisymmetric.hpp"
#include "sim/mechanics/units.hpp"
#include "src/study/json_parts.hpp"
#include "src/study/triaxial/runaway_balance.hpp"

namespace triax::src {
namespace {

using study::Json;

study::Json plain(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? study::Json(*value) : study::Json(nullptr);
}

// The field value with the shortest digits that stands for this SI value, so that 56.5 kPa is not
// printed as 56.500000000000007.
study::Json field(const std::optional<double>& si, const sim::Unit& unit) {
  return si && std::isfinite(*si) ? study::Json(sim::to_field(*si, unit)) : study::Json(nullptr);
}

study::Json kPa(const std::optional<double>& pa) { return field(pa, *sim::find_unit("kPa")); }
study::Json mm(const std::optional<double>& metres) { return field(metres, *sim::find_unit("mm")); }

study::Json deg(const std::optional<double>& rad) {
  return plain(rad ? std::optional(sim::degrees(*rad)) : std::nullopt);
}

template <class T>
study::Json maybe(const std::optional<T>& value) {
  return value ? study::Json(*value) : study::Json(nullptr);
}

study::Json text(const std::string& value) {
  return value.empty() ? study::Json(nullptr) : study::Json(value);
}

// A number of a programme stays one.
study::Json number_or_text(const std::string& value) {
  const study::Json read = study::Json::parse(value, nullptr, false);
  return read.is_number() ? read : study::Json(value);
}

study::Json sweep_json(const std::optional<db::SweepMembership>& sweep) {
  if (!sweep) return nullptr;
  study::Json values = study::Json::object();
  for (const auto& [key, value] : sweep->values) values[key] = number_or_text(value);
  return {{"name", sweep->sweep}, {"place", sweep->place}, {"values", std::move(values)}};
}

study::Json test_json(const db::StoredTest& test) {
  const auto& header = test.header;
  return {{"id", test.id},
          {"name", header.name},
          {"origin", lab::to_string(header.origin)},
          {"programme", text(header.programme)},
          {"source", text(header.source)},
          {"dialect", text(header.dialect)},
          {"seed", maybe(header.seed)},
          {"status", db::to_string(test.status)},
          {"recorded_at", text(test.recorded_at)},
          {"readings", test.summary.readings},
          {"axis", header.has_time ? "time" : "axial_strain"},
          {"sweep", sweep_json(test.sweep)}};
}

study::Json specimen_json(const lab::SpecimenInfo& specimen) {
  return {{"height_mm", mm(specimen.height_m)},
          {"diameter_mm", mm(specimen.diameter_m)},
          {"void_ratio", plain(specimen.void_ratio)},
          {"consolidated_void_ratio", plain(specimen.consolidated_void_ratio)},
          {"consolidated_height_mm", mm(specimen.consolidated_height_m)},
          {"dry_mass_g", field(specimen.dry_mass_kg, *sim::find_unit("g"))},
          {"specific_gravity", plain(specimen.specific_gravity)},
          {"membrane_thickness_mm", mm(specimen.membrane_thickness_m)},
          {"membrane_modulus_kPa", kPa(specimen.membrane_modulus_pa)},
          {"limit_friction_angle_deg", deg(specimen.limit_friction_angle_rad)},
          {"material", text(specimen.material)}};
}

study::Json consolidation_json(const db::StoredTest& test) {
  const auto& consolidation = test.summary.consolidation;
  return {{"p_eff_kPa", kPa(consolidation.p_eff_pa)},
          {"b_value", plain(consolidation.b_value)},
          {"void_ratio", plain(study::void_ratio(test))},
          {"height_mm", mm(consolidation.height_m)},
          {"diameter_mm", mm(consolidation.diameter_m)}};
}

void put_instant(study::Json& object, const std::optional<lab::Instant>& known) {
  const lab::Instant at = known.value_or(lab::Instant{});
  object["reading"] = known ? study::Json(at.reading) : study::Json(nullptr);
  object["time_s"] = plain(at.time_s);
  object["axial_strain"] = plain(at.axial_strain);
  object["q_kPa"] = kPa(at.q_pa);
  object["p_eff_kPa"] = kPa(at.p_eff_pa);
  object["pore_pressure_kPa"] = kPa(at.pore_pressure_pa);
  object["eta"] = plain(at.eta());
  object["phi_mob_deg"] = deg(at.phi_mob_rad());
}

study::Json run_aways_json(const std::vector<lab::RunAwayTruth>& run_aways) {
  study::Json list = study::Json::array();
  for (const auto& run_away : run_aways)
    list.push_back({{"start_s", plain(run_away.start_s)},
                    {"largest_kinetic_energy_J", plain(run_away.largest_kinetic_energy_j)},
                    {"largest_at_s", plain(run_away.largest_at_s)},
                    {"kinetic_energy_J", plain(run_away.kinetic_energy_j)},
                    {"second_order_work_J", plain(run_away.second_order_work_j)},
                    {"kinetic_energy_over_half_work", plain(study::balance_of(run_away).ratio)},
                    {"expected_ratio", plain(run_away.expected_ratio)},
                    {"end_s", plain(run_away.end_s)},
                    {"ending", text(std::string(to_string(run_away.end)))}});
  return list;
}

study::Json truth_json(const std::optional<lab::Truth>& truth) {
  if (!truth) return nullptr;
  const lab::Instant at = study::true_instant(*truth);
  return {{"lost_sustainability", truth->lost_sustainability},
          {"time_s", plain(truth->time_s)},
          {"axial_strain", plain(truth->axial_strain)},
          {"q_kPa", kPa(truth->q_pa)},
          {"p_eff_kPa", kPa(truth->p_eff_pa)},
          {"pore_pressure_kPa", kPa(truth->pore_pressure_pa)},
          {"eta", plain(at.eta())},
          {"phi_mob_deg", deg(at.phi_mob_rad())},
          {"run_aways", run_aways_json(truth->run_aways)}};
}

study::Json criteria_json(const std::vector<lab::Criterion>& criteria) {
  study::Json list = study::Json::array();
  for (const auto& criterion : criteria)
    list.push_back({{"name", criterion.name},
                    {"detected", criterion.detected},
                    {"reading", maybe(criterion.reading)},
                    {"time_s", plain(criterion.time_s)},
                    {"eta", plain(criterion.eta)},
                    {"evidence", text(criterion.evidence)}});
  return list;
}

study::Json collapse_json(const db::StoredTest& test) {
  const auto& collapse = test.summary.collapse;
  const bool known = study::has_verdict(test);
  study::Json object;
  object["detected"] = known ? study::Json(collapse.detected()) : study::Json(nullptr);
  object["kind"] = known ? study::Json(lab::to_string(collapse.kind)) : study::Json(nullptr);
  object["inside_limit_surface"] = maybe(collapse.inside_limit_surface);
  put_instant(object, collapse.onset);
  object["second_order_work_normalised"] = plain(collapse.second_order_work_normalised);
  object["second_order_work_error"] = plain(collapse.second_order_work_error);
  object["limit_stress_ratio"] = plain(collapse.limit_stress_ratio);
  object["limit_source"] = text(collapse.limit_source);
  object["criteria"] = criteria_json(collapse.criteria);
  object["truth"] = truth_json(test.summary.truth);
  return object;
}

study::Json checks_json(const std::vector<lab::Check>& checks) {
  study::Json list = study::Json::array();
  for (const auto& check : checks)
    list.push_back({{"name", to_string(check.kind)},
                    {"measured", plain(check.measured)},
                    {"limit", plain(check.limit)},
                    {"ok", check.ok},
                    {"note", text(check.note)}});
  return list;
}

study::Json report_json(const db::StoredTest& test) {
  study::Json peak;
  put_instant(peak, test.summary.peak);
  return {{"test", test_json(test)},
          {"specimen", specimen_json(test.header.specimen)},
          {"consolidation", consolidation_json(test)},
          {"peak", std::move(peak)},
          {"collapse", collapse_json(test)},
          {"checks", checks_json(test.summary.checks)},
          {"warnings", study::warnings(test)}};
}

}  // namespace

std::string json_of_test(const study::TestResult& test) {
  return report_json(test.stored).dump(2, ' ', false, study::Json::error_handler_t::replace);
}

std::string json_report(const std::vector<study::TestResult>& tests) {
  study::Json document = study::Json::array();
  for (const auto& test : tests) document.push_back(report_json(test.stored));
  if (tests.size() == 1) document = study::Json(document.front());
  return document.dump(2, ' ', false, study::Json::error_handler_t::replace) + '\n';
}

}  // namespace triax::src
