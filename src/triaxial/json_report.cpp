// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/json_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/measured/instant.hpp"
#include "sim/mechanics/axisymmetric.hpp"
#include "sim/mechanics/units.hpp"
#include "src/study/json_parts.hpp"
#include "src/study/triaxial/event_json.hpp"
#include "src/study/triaxial/runaway_balance.hpp"

namespace triax::src {
namespace {

using study::Json;

// The field value with the shortest digits that stands for this SI value, so that 56.5 kPa is not
// printed as 56.500000000000007.
Json field(const std::optional<double>& si, const sim::Unit& unit) {
  return si && std::isfinite(*si) ? Json(sim::to_field(*si, unit)) : Json(nullptr);
}

Json mm(const std::optional<double>& metres) { return field(metres, *sim::find_unit("mm")); }

template <class T>
Json maybe(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// A number of a programme stays one.
Json number_or_text(const std::string& value) {
  const Json read = Json::parse(value, nullptr, false);
  return read.is_number() ? read : Json(value);
}

Json sweep_json(const std::optional<db::SweepMembership>& sweep) {
  if (!sweep) return nullptr;
  Json values = Json::object();
  for (const auto& [key, value] : sweep->values) values[key] = number_or_text(value);
  return {{"name", sweep->sweep}, {"place", sweep->place}, {"values", std::move(values)}};
}

Json test_json(const db::StoredTest& test) {
  const auto& header = test.header;
  return {{"id", test.id},
          {"name", header.name},
          {"origin", lab::to_string(header.origin)},
          {"programme", study::json_text(header.programme)},
          {"source", study::json_text(header.source)},
          {"dialect", study::json_text(header.dialect)},
          {"digest", study::json_text(header.digest)},
          {"seed", maybe(header.seed)},
          {"status", db::to_string(test.status)},
          {"last_sign_of_life", test.sign_of_life ? Json(test.sign_of_life->at) : Json()},
          {"stored_at", study::json_text(test.stored_at)},
          {"readings", test.summary.readings},
          {"axis", header.has_time ? "time" : "axial_strain"},
          {"sweep", sweep_json(test.sweep)},
          {"tags", test.tags}};
}

Json specimen_json(const lab::SpecimenInfo& specimen) {
  return {{"height_mm", mm(specimen.height_m)},
          {"diameter_mm", mm(specimen.diameter_m)},
          {"void_ratio", study::json_number(specimen.void_ratio)},
          {"consolidated_void_ratio", study::json_number(specimen.consolidated_void_ratio)},
          {"consolidated_height_mm", mm(specimen.consolidated_height_m)},
          {"dry_mass_g", field(specimen.dry_mass_kg, *sim::find_unit("g"))},
          {"specific_gravity", study::json_number(specimen.specific_gravity)},
          {"membrane_thickness_mm", mm(specimen.membrane_thickness_m)},
          {"membrane_modulus_kPa", study::json_kPa(specimen.membrane_modulus_pa)},
          {"limit_friction_angle_deg", study::json_deg(specimen.limit_friction_angle_rad)},
          {"cohesion_kPa", study::json_kPa(specimen.cohesion_pa)},
          {"material", study::json_text(specimen.material)}};
}

Json consolidation_json(const db::StoredTest& test) {
  const auto& consolidation = test.summary.consolidation;
  return {{"p_eff_kPa", study::json_kPa(consolidation.p_eff_pa)},
          {"b_value", study::json_number(consolidation.b_value)},
          {"void_ratio", study::json_number(study::void_ratio(test))},
          {"height_mm", mm(consolidation.height_m)},
          {"diameter_mm", mm(consolidation.diameter_m)}};
}

void put_instant(Json& object, const std::optional<lab::Instant>& known) {
  const lab::Instant at = known.value_or(lab::Instant{});
  object["reading"] = known ? Json(at.reading) : Json(nullptr);
  object["time_s"] = study::json_number(at.time_s);
  object["axial_strain"] = study::json_number(at.axial_strain);
  object["q_kPa"] = study::json_kPa(at.q_pa);
  object["p_eff_kPa"] = study::json_kPa(at.p_eff_pa);
  object["pore_pressure_kPa"] = study::json_kPa(at.pore_pressure_pa);
  object["eta"] = study::json_number(at.eta());
  object["phi_mob_deg"] = study::json_deg(at.phi_mob_rad());
}

Json run_aways_json(const std::vector<lab::RunAwayTruth>& run_aways) {
  Json list = Json::array();
  for (const auto& run_away : run_aways)
    list.push_back(
        {{"start_s", study::json_number(run_away.start_s)},
         {"largest_kinetic_energy_J", study::json_number(run_away.largest_kinetic_energy_j)},
         {"largest_at_s", study::json_number(run_away.largest_at_s)},
         {"kinetic_energy_J", study::json_number(run_away.kinetic_energy_j)},
         {"second_order_work_J", study::json_number(run_away.second_order_work_j)},
         {"kinetic_energy_over_half_work", study::json_number(study::balance_of(run_away).ratio)},
         {"expected_ratio", study::json_number(run_away.expected_ratio)},
         {"end_s", study::json_number(run_away.end_s)},
         {"ending", study::json_text(std::string(to_string(run_away.end)))}});
  return list;
}

Json true_loss_of_control_json(const lab::Truth& truth) {
  const auto lost = study::true_loss_of_control(truth);
  if (!lost) return nullptr;
  Json object;
  put_instant(object, lost);
  object.erase("reading");  // no instrument saw it
  return object;
}

Json truth_json(const std::optional<lab::Truth>& truth) {
  if (!truth) return nullptr;
  const lab::Instant at = study::true_instant(*truth);
  return {{"lost_sustainability", truth->lost_sustainability},
          {"time_s", study::json_number(truth->time_s)},
          {"axial_strain", study::json_number(truth->axial_strain)},
          {"q_kPa", study::json_kPa(truth->q_pa)},
          {"p_eff_kPa", study::json_kPa(truth->p_eff_pa)},
          {"pore_pressure_kPa", study::json_kPa(truth->pore_pressure_pa)},
          {"eta", study::json_number(at.eta())},
          {"phi_mob_deg", study::json_deg(at.phi_mob_rad())},
          {"loss_of_control", true_loss_of_control_json(*truth)},
          {"run_aways", run_aways_json(truth->run_aways)}};
}

void put_interval(Json& object, const std::optional<lab::StressInterval>& of) {
  const bool known = of.has_value();
  const lab::StressInterval interval = of.value_or(lab::StressInterval{});
  const auto if_known = [known](double value) {
    return known ? std::optional(value) : std::nullopt;
  };
  object["eta_low"] = study::json_number(if_known(interval.eta.low));
  object["eta_high"] = study::json_number(if_known(interval.eta.high));
  object["q_low_kPa"] = study::json_kPa(if_known(interval.q_pa.low));
  object["q_high_kPa"] = study::json_kPa(if_known(interval.q_pa.high));
  object["p_eff_low_kPa"] = study::json_kPa(if_known(interval.p_eff_pa.low));
  object["p_eff_high_kPa"] = study::json_kPa(if_known(interval.p_eff_pa.high));
}

/// Repeatability and the errors that all readings have in common.
void put_total(Json& object, const std::optional<lab::TotalUncertainty>& total) {
  object["total_interval"] = nullptr;
  object["uncertainty_budget"] = nullptr;
  if (!total) return;
  object["total_interval"] = Json::object();
  put_interval(object["total_interval"], total->interval);
  object["uncertainty_budget"] = Json::array();
  for (const lab::UncertaintySource& source : total->budget)
    object["uncertainty_budget"].push_back(
        {{"name", source.name}, {"share", study::json_number(source.share)}});
}

Json known_instant_json(const std::optional<lab::Instant>& at,
                        const std::optional<lab::Moment>& detected_at) {
  if (!at) return nullptr;
  Json object;
  put_instant(object, at);
  put_interval(object, at->interval);
  object["detected_at"] = study::moment_json(detected_at);
  return object;
}

Json criteria_json(const std::vector<lab::Criterion>& criteria) {
  Json list = Json::array();
  for (const auto& criterion : criteria) {
    const auto& detected_at = criterion.detected_at;
    list.push_back(
        {{"name", criterion.name},
         {"detected", maybe(criterion.detected)},
         {"reading", maybe(criterion.reading)},
         {"time_s", study::json_number(criterion.time_s)},
         {"eta", study::json_number(criterion.eta)},
         {"detected_at_reading", detected_at ? Json(detected_at->reading) : Json(nullptr)},
         {"detected_at_time_s",
          study::json_number(detected_at ? detected_at->time_s : std::nullopt)},
         {"evidence", study::json_text(criterion.evidence)}});
  }
  return list;
}

Json judged_json(const db::StoredTest& test) {
  const lab::Collapse& c = test.summary.collapse;
  return {{"from_reading", maybe(c.judged_from)},
          {"to_reading", maybe(c.judged_until)},
          {"complete", study::has_verdict(test) && c.judged_until_reason.empty()},
          {"reason", study::json_text(c.judged_until_reason)}};
}

Json nearest_json(const std::optional<lab::Nearest>& nearest) {
  if (!nearest) return nullptr;
  return {{"reading", nearest->reading},
          {"second_order_work_normalised", study::json_number(nearest->normalised)},
          {"second_order_work_error", study::json_number(nearest->error)}};
}

/// The measured values at the onset's reading; those of the onset are fitted to its surroundings.
Json reading_itself_json(const db::StoredTest& test) {
  if (!test.state_at_onset) return nullptr;
  Json object;
  put_instant(object, lab::instant_of(*test.state_at_onset, test.header.has_time));
  return object;
}

Json collapse_json(const db::StoredTest& test) {
  const auto& collapse = test.summary.collapse;
  const bool known = study::has_verdict(test);
  Json object;
  object["detected"] = known ? Json(collapse.detected()) : Json(nullptr);
  object["kind"] = known ? Json(lab::to_string(collapse.kind)) : Json(nullptr);
  object["judged"] = judged_json(test);
  object["inside_limit_surface"] = maybe(collapse.inside_limit_surface);
  put_instant(object, collapse.onset);
  put_interval(object, collapse.onset ? collapse.onset->interval : std::nullopt);
  put_total(object, collapse.onset ? collapse.onset->total : std::nullopt);
  object["detected_at"] = study::moment_json(collapse.onset_detected_at);
  object["loss_of_control"] =
      known_instant_json(collapse.loss_of_control, collapse.loss_of_control_detected_at);
  object["warning"] = {{"approaching", study::forecast_json(collapse.approaching)},
                       {"imminent", study::forecast_json(collapse.imminent)}};
  object["reading_itself"] = reading_itself_json(test);
  object["second_order_work_normalised"] =
      study::json_number(collapse.second_order_work_normalised);
  object["second_order_work_error"] = study::json_number(collapse.second_order_work_error);
  object["strength_lost"] = study::json_number(collapse.strength_lost);
  object["nearest"] = nearest_json(collapse.nearest);
  object["limit_stress_ratio"] = study::json_number(collapse.limit_stress_ratio);
  object["limit_intercept_kPa"] = study::json_kPa(collapse.limit_intercept_pa);
  object["limit_source"] = study::json_text(collapse.limit_source);
  object["criteria"] = criteria_json(collapse.criteria);
  object["truth"] = truth_json(test.summary.truth);
  return object;
}

Json strength_at_json(const std::optional<lab::Instant>& at) {
  if (!at) return nullptr;
  return {{"reading", at->reading},
          {"time_s", study::json_number(at->time_s)},
          {"axial_strain", study::json_number(at->axial_strain)},
          {"q_kPa", study::json_kPa(at->q_pa)}};
}

Json undrained_strength_json(const std::optional<lab::UndrainedStrength>& strength) {
  if (!strength) return nullptr;
  Json object = strength_at_json(strength->at);
  object["c_u_kPa"] = study::json_kPa(strength->c_u_pa());
  object["peaked"] = strength->peaked;
  object["last_axial_strain"] = study::json_number(strength->last_axial_strain);
  object["at_15_pct"] = strength_at_json(strength->at_15_pct);
  return object;
}

Json cyclic_json(const std::optional<lab::CyclicLoading>& cyclic) {
  if (!cyclic) return nullptr;
  const auto at_json = [](const std::optional<lab::CycleInstant>& at) {
    return at ? Json{{"reading", at->instant.reading}, {"cycle", at->cycle}} : Json(nullptr);
  };
  return {{"cycles", cyclic->cycles},
          {"q_low_kPa", study::json_kPa(cyclic->q_low_pa)},
          {"q_high_kPa", study::json_kPa(cyclic->q_high_pa)},
          {"cyclic_stress_ratio", study::json_number(cyclic->stress_ratio)},
          {"largest_pore_pressure_ratio", study::json_number(cyclic->largest_pore_pressure_ratio)},
          {"largest_double_amplitude", study::json_number(cyclic->largest_double_amplitude)},
          {"liquefied", at_json(cyclic->liquefied)},
          {"double_amplitude_5_pct", at_json(cyclic->double_amplitude)}};
}

Json events_json(const std::vector<lab::Event>& events) {
  Json list = Json::array();
  for (const auto& event : events) list.push_back(study::event_json(event));
  return list;
}

Json checks_json(const std::vector<lab::Check>& checks) {
  Json list = Json::array();
  for (const auto& check : checks)
    list.push_back({{"name", to_string(check.kind)},
                    {"measured", study::json_number(check.measured)},
                    {"limit", study::json_number(check.limit)},
                    {"ok", check.ok},
                    {"note", study::json_text(check.note)}});
  return list;
}

Json notes_json(const std::vector<lab::Note>& notes) {
  Json list = Json::array();
  for (const auto& note : notes)
    list.push_back(
        {{"label", study::json_text(note.label)}, {"text", study::json_text(note.text)}});
  return list;
}

Json guesses_json(const std::vector<lab::Guess>& guesses) {
  Json list = Json::array();
  for (const auto& guess : guesses)
    list.push_back({{"what", study::json_text(guess.what)},
                    {"taken", study::json_text(guess.taken)},
                    {"evidence", study::json_text(guess.evidence)},
                    {"remedy", study::json_text(guess.remedy)}});
  return list;
}

Json guard_json(const std::optional<lab::GuardOutcome>& guard) {
  if (!guard) return nullptr;
  Json without = nullptr;
  if (const auto& w = guard->without)
    without = {{"kind", std::string(to_string(w->kind))},
               {"axial_strain", study::json_number(w->last_axial_strain)},
               {"lost", study::moment_json(w->lost)}};
  return {{"level", std::string(to_string(guard->level))},
          {"done", study::json_text(guard->done)},
          {"reading", guard->at.reading},
          {"time_s", study::json_number(guard->at.time_s)},
          {"axial_strain", study::json_number(guard->at.axial_strain)},
          {"q_kPa", study::json_kPa(guard->at.q_pa)},
          {"p_eff_kPa", study::json_kPa(guard->at.p_eff_pa)},
          {"second_order_work_normalised", study::json_number(guard->second_order_work_normalised)},
          {"last_axial_strain", study::json_number(guard->last_axial_strain)},
          {"without", std::move(without)}};
}

/// Nothing for a test that was never corrected.
void put_revisions(Json& document, const db::StoredTest& test) {
  if (test.revisions.empty()) return;
  Json& list = document["revisions"] = Json::array();
  for (const db::Revision& revision : test.revisions) {
    Json values = Json::array();
    for (const db::RevisedValue& value : revision.values)
      values.push_back({{"key", value.key},
                        {"old", study::json_text(value.before)},
                        {"new", study::json_text(value.after)}});
    list.push_back({{"revision", revision.number},
                    {"revised_at", revision.revised_at},
                    {"former_kind",
                     revision.former_kind ? Json(to_string(*revision.former_kind)) : Json(nullptr)},
                    {"former_eta", study::json_number(revision.former_eta)},
                    {"values", std::move(values)}});
  }
}

Json document_of(const db::StoredTest& test) {
  Json peak;
  put_instant(peak, test.summary.peak);
  Json document = {
      {"test", test_json(test)},
      {"specimen", specimen_json(test.header.specimen)},
      {"consolidation", consolidation_json(test)},
      {"peak", std::move(peak)},
      {"undrained_strength", undrained_strength_json(test.summary.undrained_strength)},
      {"collapse", collapse_json(test)},
      {"cyclic", cyclic_json(test.summary.cyclic)},
      {"guard", guard_json(test.summary.guard)},
      {"events", events_json(test.events)},
      {"corrections", {{"membrane", study::json_text(test.summary.membrane_correction)}}},
      {"notes", notes_json(test.header.notes)},
      {"guesses", guesses_json(test.header.guesses)},
      {"checks", checks_json(test.summary.checks)},
      {"warnings", study::warnings(test)}};
  put_revisions(document, test);
  return document;
}

}  // namespace

Json test_document(const db::StoredTest& test) { return document_of(test); }

std::string json_of_test(const study::TestResult& test) {
  return document_of(test.stored).dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string json_of_instants(const db::StoredTest& test) {
  const lab::Collapse& collapse = test.summary.collapse;
  const auto onset = study::collapse_onset(test);
  Json document;
  document["onset"] = known_instant_json(onset, collapse.onset_detected_at);
  if (onset) put_total(document["onset"], onset->total);
  document["loss_of_control"] =
      known_instant_json(collapse.loss_of_control, collapse.loss_of_control_detected_at);
  return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string json_in_short(const db::StoredTest& test) {
  Json document = {{"test", test_json(test)},
                   {"specimen", specimen_json(test.header.specimen)},
                   {"collapse", collapse_json(test)},
                   {"warnings", study::warnings(test)}};
  put_revisions(document, test);
  return study::json_document(document);
}

std::string json_report(const std::vector<study::TestResult>& tests) {
  Json document = Json::array();
  for (const auto& test : tests) document.push_back(document_of(test.stored));
  if (tests.size() == 1) document = Json(document.front());
  return study::json_document(document);
}

}  // namespace triax::src
