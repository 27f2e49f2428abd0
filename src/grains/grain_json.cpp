// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_json.hpp"

#include "lab/grains/grain_words.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "src/study/grains/grain_curves.hpp"
#include "src/study/grains/grain_path_findings.hpp"
#include "src/study/grains/grain_rose_findings.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {
namespace {

study::Json count_json(std::int64_t count) {
  return count == lab::kNotStored ? study::Json(nullptr) : study::Json(count);
}

study::Json measures_json(const sim::GrainMeasures& m) {
  return {{"axial_stress_kPa", study::json_kPa(m.wall_stress_pa[sim::kAxial])},
          {"radial_stress_kPa", study::json_kPa(0.5 * (m.wall_stress_pa[sim::kRadial[0]] +
                                                       m.wall_stress_pa[sim::kRadial[1]]))},
          {"porosity", study::json_number(m.porosity)},
          {"void_ratio", study::json_number(m.void_ratio)},
          {"coordination", study::json_number(m.coordination)},
          {"grain_contacts", count_json(m.grain_contacts)},
          {"wall_contacts", count_json(m.wall_contacts)},
          {"sliding_contacts", count_json(m.sliding_contacts)},
          {"floating_grains", count_json(m.floating_grains)},
          {"grains_outside", count_json(m.grains_outside)},
          {"kinetic_energy_J", study::json_number(m.kinetic_energy_j)},
          {"unbalanced", study::json_number(m.unbalanced)}};
}

study::Json law_json(const sim::ContactLaw& law) {
  return {{"kn_over_ds_MPa", law.stiffness_over_diameter_pa / 1e6},
          {"kn_over_ds_reading", lab::word(law.reading)},
          {"kt_over_kn", law.tangential_ratio},
          {"friction_deg", study::json_deg(law.friction_angle)},
          {"density_kg_per_m3", law.density_kg_per_m3},
          {"damping", law.damping}};
}

study::Json specimen_json(const std::optional<lab::ReportedGrains>& g) {
  if (!g) return nullptr;
  study::Json grading = {{"smallest_mm", study::json_number(g->smallest_m * 1e3)},
                         {"median_mm", study::json_number(g->median_m * 1e3)},
                         {"largest_mm", study::json_number(g->largest_m * 1e3)}};
  const bool loaded = !g->state_file.empty();  // a state, or a packing
  return {{"grains", g->grains},
          {"diameter", std::move(grading)},
          {"state_file", study::json_text(g->state_file)},
          {"seed", loaded ? study::Json(nullptr) : study::Json(g->seed)},
          {"compaction_friction_deg", study::json_deg(g->compaction_friction)},
          {"compaction_pressure_kPa", study::json_kPa(g->compaction_pressure)},
          {"porosity_wanted", study::json_number(g->porosity_wanted)},
          {"compactions", loaded ? study::Json(nullptr) : study::Json(g->trials)},
          {"law", law_json(g->law)},
          {"time_step_s", g->time_step_s},
          {"state", measures_json(g->measures)}};
}

study::Json stress_json(const sim::AxisymmetricStress& s) {
  return {{"axial_kPa", study::json_kPa(s.axial)}, {"radial_kPa", study::json_kPa(s.radial)}};
}
study::Json strain_json(const sim::AxisymmetricStrain& e) {
  return {{"axial", study::json_number(e.axial)}, {"radial", study::json_number(e.radial)}};
}

study::Json point_json(const sim::GrainPathPoint& at) {
  return {{"time_s", study::json_number(at.time_s)},
          {"strain", strain_json(at.strain)},
          {"volumetric_strain", study::json_number(at.volumetric_strain)},
          {"stress", stress_json(at.stress)},
          {"p_kPa", study::json_kPa(at.p_pa)},
          {"q_kPa", study::json_kPa(at.q_pa)},
          {"eta", at.p_pa > 0 ? study::json_number(at.stress_ratio()) : study::Json(nullptr)},
          {"path_stress_kPa", study::json_kPa(at.path_stress_pa)},
          {"porosity", study::json_number(at.porosity)},
          {"coordination", study::json_number(at.coordination)},
          {"sliding_share", study::json_number(at.sliding_share)},
          {"kinetic_energy_J", study::json_number(at.kinetic_energy_j)},
          {"unbalanced", study::json_number(at.unbalanced)}};
}

study::Json peak_json(const std::optional<study::GrainPeak>& peak, const char* key, double unit) {
  if (!peak) return nullptr;
  return {{key, study::json_number(peak->value / unit)},
          {"axial_strain", study::json_number(peak->axial_strain)},
          {"point", peak->point},
          {"fell", peak->fell}};
}

study::Json came_json(const lab::ReportedGrainPath& came) {
  const study::GrainPathFindings found = study::path_findings(came.path, came.points);
  const auto works = study::works_along(came);
  study::Json marks = study::Json::array(), points = study::Json::array();
  for (const auto& mark : came.marks)
    marks.push_back(
        {{"name", mark.name}, {"at", mark.at ? point_json(*mark.at) : study::Json(nullptr)}});
  for (std::size_t i = 0; i < came.points.size(); ++i) {
    points.push_back(point_json(came.points[i]));
    points.back()["w2_J_per_m3"] = study::json_number(works[i]);
  }
  study::Json negative = nullptr;
  if (found.first_negative) {
    negative = point_json(came.points[*found.first_negative]);
    negative["point"] = *found.first_negative;
  }
  const bool strain_path = came.path.kind == sim::GrainPathKind::strain_path;
  return {{"kind", lab::word(came.path.kind)},
          {"R", strain_path ? study::Json(came.path.ratio) : study::Json(nullptr)},
          {"end", lab::word(came.end)},
          {"peak_q", peak_json(found.q, "q_kPa", 1e3)},
          {"peak_eta", peak_json(found.eta, "eta", 1)},
          {"peak_path_stress", peak_json(found.path_stress, "path_stress_kPa", 1e3)},
          {"w2_window_points", came.path.samples > 0
                                   ? study::Json(study::work_window(came.path.samples))
                                   : study::Json(nullptr)},
          {"w2_first_negative", std::move(negative)},
          {"kinetic_energy_most_J", study::json_number(found.most_kinetic_j)},
          {"marks", came.marks_stored ? std::move(marks) : study::Json(nullptr)},
          {"points", std::move(points)}};
}

study::Json came_json(const lab::ReportedGrainRest& came) {
  const auto& settling = came.rest.settling;
  return {{"held", came.strain_held ? "walls" : "stresses"},
          {"at_rest", came.rest.at_rest},
          {"steps", count_json(settling.steps)},
          {"unbalanced", study::json_number(settling.unbalanced)},
          {"stress_error_Pa",
           came.strain_held ? study::Json(nullptr) : study::json_number(settling.stress_error_pa)},
          {"path_stress_kPa", study::json_kPa(came.rest.path_stress_pa)}};
}

study::Json ledger_json(const sim::GrainLedger& l) {
  const auto axes = [](const std::array<double, 3>& of) {
    return study::Json::array(
        {study::json_number(of[0]), study::json_number(of[1]), study::json_number(of[2])});
  };
  return {{"walls_J", study::json_number(l.walls_j)},
          {"elastic_start_J", study::json_number(l.elastic_start_j)},
          {"elastic_end_J", study::json_number(l.elastic_end_j)},
          {"kinetic_start_J", study::json_number(l.kinetic_start_j)},
          {"kinetic_end_J", study::json_number(l.kinetic_end_j)},
          {"friction_J", study::json_number(l.friction_j)},
          {"damping_J", study::json_number(l.damping_j)},
          {"stopped_J", study::json_number(l.stopped_j)},
          {"error_J", study::json_number(l.energy_error_j())},
          {"error_share", study::json_number(l.energy_error_share())},
          {"momentum_kg_m_per_s",
           {{"walls", axes(l.walls_impulse)},
            {"damping", axes(l.damping_impulse)},
            {"stopped", axes(l.stopped_impulse)},
            {"start", axes(l.momentum_start)},
            {"end", axes(l.momentum_end)},
            {"error", study::json_number(l.momentum_error())}}}};
}

/// Null for what a stopped probe does not tell.
study::Json probe_json(const sim::GrainProbe& p, std::optional<double> angle,
                       const lab::ReportedGrainRose& rose) {
  const bool parts_stored = rose.parts_stored, by_stress = rose.kind == sim::ProbeKind::stress;
  const auto part = [&](double value) {
    return parts_stored ? study::json_number(value) : study::Json(nullptr);
  };
  study::Json one = {
      {"alpha_deg", study::json_deg(angle)},
      {"norm_kPa", by_stress ? study::json_kPa(p.norm_pa) : study::Json(nullptr)},
      {"norm_strain", by_stress ? study::Json(nullptr) : study::json_number(p.norm_strain)}};
  one["stopped"] = p.stopped;
  if (p.stopped) return one;
  const auto& w = p.work;
  one.update({{"at_rest", p.at_rest},
              {"stress", stress_json(p.stress)},
              {"strain", strain_json(p.strain)},
              {"w2_J_per_m3",
               {{"lagrangian", study::json_number(w.lagrangian)},
                {"eulerian", study::json_number(w.eulerian())},
                {"stress_part", study::json_number(w.stress_part)},
                {"volume_part", study::json_number(w.volume_part)},
                {"transport_part", study::json_number(w.transport_part)},
                {"microscopic", study::json_number(w.microscopic())},
                {"normal_part", part(w.normal_part)},
                {"tangential_part", part(w.tangential_part)},
                {"non_permanent_part", part(w.non_permanent_part)},
                {"fixed_frame", study::json_number(w.fixed_frame)}}},
              {"boundary_part_J_per_m3", study::json_number(w.boundary_part)},
              {"gap_J_per_m3",
               {{"micro_less_macro", study::json_number(w.gap())},
                {"grains_turning", study::json_number(w.grains_turning)},
                {"contacts_turning", study::json_number(w.contacts_turning)},
                {"out_of_balance", study::json_number(w.out_of_balance)},
                {"left", study::json_number(w.gap_left())}}},
              {"w2_normalised", angle ? study::json_number(w.normalised) : study::Json(nullptr)},
              {"micro_over_macro",
               angle ? study::json_number(study::micro_over_macro(p)) : study::Json(nullptr)},
              {"sliding_share", study::json_number(p.sliding_share)},
              {"non_permanent_share", study::json_number(w.non_permanent_share())},
              {"kinetic_energy_most_J", study::json_number(p.most_kinetic_j)},
              {"steps", p.steps},
              {"unbalanced", study::json_number(p.unbalanced)},
              {"stress_error_Pa", study::json_number(p.stress_error_pa)},
              {"ledger", ledger_json(p.ledger)}});
  return one;
}

study::Json ranges_json(const std::vector<study::AngleRange>& ranges) {
  study::Json all = study::Json::array();
  for (const auto& [from, to, directions] : ranges)
    all.push_back({{"from_deg", study::json_deg(from)},
                   {"to_deg", study::json_deg(to)},
                   {"directions", directions}});
  return all;
}

study::Json came_json(const lab::ReportedGrainRose& came) {
  const auto& [stress, angles, rose] = came.made;
  const study::GrainRoseFindings found = study::rose_findings(rose);
  const bool any = found.made > 0;
  study::Json probes = study::Json::array();
  for (std::size_t i = 0; i < rose.probes.size(); ++i)
    probes.push_back(probe_json(rose.probes[i], angles[i], came));
  return {
      {"kind", lab::word(came.kind)},
      {"norm_kPa",
       came.kind == sim::ProbeKind::stress ? study::json_kPa(came.norm_pa) : study::Json(nullptr)},
      {"norm_strain", came.kind == sim::ProbeKind::strain ? study::json_number(came.norm_strain)
                                                          : study::Json(nullptr)},
      {"stress", stress_json(stress)},
      {"made", found.made},
      {"at_rest", found.at_rest},
      {"negative_w2", ranges_json(found.negative)},
      {"least_w2_normalised", study::json_number(found.least_normalised)},
      {"least_alpha_deg", study::json_deg(found.least_angle)},
      {"agreement", {{"within", study::kAgreement}, {"ranges", ranges_json(found.agreeing)}}},
      {"irreversible",
       {{"contacts_above_null_probe", study::kIrreversible},
        {"ranges", ranges_json(found.irreversible)}}},
      {"dynamic",
       {{"times_least_kinetic_energy", study::kDynamic}, {"ranges", ranges_json(found.dynamic)}}},
      {"not_at_rest", ranges_json(found.not_at_rest)},
      {"kinetic_energy_most_J",
       any ? study::json_number(found.most_kinetic_j) : study::Json(nullptr)},
      {"gap",
       {{"left_share", study::json_number(found.gap_left)},
        {"grains_turning_share", study::json_number(found.gap_of_grains)},
        {"boundary_part_most_J_per_m3", study::json_number(found.max_boundary_term)}}},
      {"ledger_error_share_most", study::json_number(found.max_energy_error)},
      {"smallest_strain", study::json_number(found.smallest_strain)},
      {"null_probe_over_smallest", study::json_number(found.drift)},
      {"null_probe", probe_json(rose.null_probe, {}, came)},
      {"probes", std::move(probes)}};
}

study::Json came_json(const lab::ReportedPerturbation& came) {
  study::Json points = study::Json::array();
  for (const auto& at : came.points)
    points.push_back({{"time_s", study::json_number(at.time_s)},
                      {"path_stress_kPa", study::json_kPa(at.path_stress_pa)},
                      {"chi", study::json_number(at.stress_share)},
                      {"p_kPa", study::json_kPa(at.p_pa)},
                      {"axial_strain", study::json_number(at.axial_strain)},
                      {"kinetic_energy_J", study::json_number(at.kinetic_energy_j)},
                      {"unbalanced", study::json_number(at.unbalanced)}});
  const auto* last = came.points.empty() ? nullptr : &came.points.back();
  return {{"R", came.how.ratio},
          {"load_step_Pa", came.how.load_step_pa},
          {"kinetic_energy_given_J", came.how.kinetic_energy_j},
          {"floating_share", study::json_number(came.how.floating_share)},
          {"seed", came.seed_stored ? study::Json(came.how.seed) : study::Json(nullptr)},
          {"end", lab::word(came.end)},
          {"time_s", last ? study::json_number(last->time_s) : study::Json(nullptr)},
          {"chi", last ? study::json_number(last->stress_share) : study::Json(nullptr)},
          {"axial_strain", last ? study::json_number(last->axial_strain) : study::Json(nullptr)},
          {"kinetic_energy_most_J", study::json_number(came.most_kinetic_j)},
          {"grains_hit", came.grains_hit},
          {"points", std::move(points)}};
}

study::Json document_of(const lab::GrainReport& report) {
  study::Json stages = study::Json::array();
  for (const auto& stage : report.stages) {
    study::Json one = {
        {"name", stage.name},
        {"action", stage.action},
        {"from", study::json_text(stage.from)},
        {"steps", stage.steps},
        {"before", measures_json(stage.before)},
        {"after", measures_json(stage.after)},
        {"ledger", stage.ledger ? ledger_json(*stage.ledger) : study::Json(nullptr)}};
    one.update(std::visit([](const auto& came) { return came_json(came); }, stage.came));
    stages.push_back(std::move(one));
  }
  return {{"origin", "simulated"},
          {"format", kGrainReportFormat},
          {"version", kGrainReportVersion},
          {"programme", {{"name", report.programme}, {"source", study::json_text(report.source)}}},
          {"specimen", specimen_json(report.specimen)},
          {"stages", std::move(stages)}};
}

}  // namespace

std::string grain_json(const lab::GrainReport& report) {
  return study::json_document(document_of(report));
}

std::string grain_run_json(const db::StoredGrainRun& run) {
  study::Json document = {
      {"id", run.id},
      {"name", run.report.programme},
      {"status", db::to_string(run.status)},
      {"last_sign_of_life", study::json_text(run.sign_of_life ? run.sign_of_life->at : "")},
      {"recorded_at", run.recorded_at},
      {"stored_whole", run.whole}};
  document.update(document_of(run.report));
  return study::json_document(document);
}

}  // namespace triax::src
