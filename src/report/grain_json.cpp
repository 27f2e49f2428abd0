#include "src/report/grain_json.hpp"

#include "lab/grains/grain_words.hpp"
#include "sim/grains/triaxial_axes.hpp"
#include "src/report/grain_path_findings.hpp"
#include "src/report/grain_rose_findings.hpp"
#include "src/report/json_parts.hpp"

namespace triax::src {
namespace {

Json measures_json(const sim::GrainMeasures& m) {
  return {{"axial_stress_kPa", json_kPa(m.wall_stress_pa[sim::kAxial])},
          {"radial_stress_kPa",
           json_kPa(0.5 * (m.wall_stress_pa[sim::kRadial[0]] + m.wall_stress_pa[sim::kRadial[1]]))},
          {"porosity", json_number(m.porosity)},
          {"void_ratio", json_number(m.void_ratio)},
          {"coordination", json_number(m.coordination)},
          {"grain_contacts", m.grain_contacts},
          {"wall_contacts", m.wall_contacts},
          {"sliding_contacts", m.sliding_contacts},
          {"floating_grains", m.floating_grains},
          {"grains_outside", m.grains_outside},
          {"kinetic_energy_J", json_number(m.kinetic_energy_j)},
          {"unbalanced", json_number(m.unbalanced)}};
}

Json law_json(const sim::ContactLaw& law) {
  return {{"kn_over_ds_MPa", law.stiffness_over_diameter_pa / 1e6},
          {"kn_over_ds_reading", lab::word(law.reading)},
          {"kt_over_kn", law.tangential_ratio},
          {"friction_deg", json_deg(law.friction_angle)},
          {"density_kg_per_m3", law.density_kg_per_m3},
          {"damping", law.damping}};
}

Json specimen_json(const std::optional<ReportedGrains>& g) {
  if (!g) return nullptr;
  Json grading = {{"smallest_mm", g->smallest_m * 1e3},
                  {"median_mm", g->median_m * 1e3},
                  {"largest_mm", g->largest_m * 1e3}};
  const bool loaded = !g->state_file.empty();  // a state, or a packing
  return {{"grains", g->grains},
          {"diameter", std::move(grading)},
          {"state_file", json_text(g->state_file)},
          {"seed", loaded ? Json(nullptr) : Json(g->seed)},
          {"compaction_friction_deg", json_deg(g->compaction_friction)},
          {"compaction_pressure_kPa", json_kPa(g->compaction_pressure)},
          {"porosity_wanted",
           json_number(g->search ? std::optional(g->search->porosity) : std::nullopt)},
          {"compactions", loaded ? Json(nullptr) : Json(g->trials)},
          {"law", law_json(g->law)},
          {"time_step_s", g->time_step_s},
          {"state", measures_json(g->measures)}};
}

Json stress_json(const sim::AxisymmetricStress& s) {
  return {{"axial_kPa", json_kPa(s.axial)}, {"radial_kPa", json_kPa(s.radial)}};
}
Json strain_json(const sim::AxisymmetricStrain& e) {
  return {{"axial", json_number(e.axial)}, {"radial", json_number(e.radial)}};
}

Json point_json(const sim::GrainPathPoint& at) {
  return {{"time_s", json_number(at.time_s)},
          {"strain", strain_json(at.strain)},
          {"volumetric_strain", json_number(at.volumetric_strain)},
          {"stress", stress_json(at.stress)},
          {"p_kPa", json_kPa(at.p_pa)},
          {"q_kPa", json_kPa(at.q_pa)},
          {"eta", at.p_pa > 0 ? json_number(at.stress_ratio()) : Json(nullptr)},
          {"path_stress_kPa", json_kPa(at.path_stress_pa)},
          {"porosity", json_number(at.porosity)},
          {"coordination", json_number(at.coordination)},
          {"sliding_share", json_number(at.sliding_share)},
          {"kinetic_energy_J", json_number(at.kinetic_energy_j)},
          {"unbalanced", json_number(at.unbalanced)}};
}

Json peak_json(const std::optional<GrainPeak>& peak, const char* key, double unit) {
  if (!peak) return nullptr;
  return {{key, json_number(peak->value / unit)},
          {"axial_strain", json_number(peak->axial_strain)},
          {"point", peak->point},
          {"fell", peak->fell}};
}

Json came_json(const ReportedGrainPath& came) {
  const GrainPathFindings found = path_findings(came.path, came.points);
  Json marks = Json::array(), points = Json::array();
  for (const auto& mark : came.marks)
    marks.push_back({{"name", mark.name}, {"at", mark.at ? point_json(*mark.at) : Json(nullptr)}});
  for (std::size_t i = 0; i < came.points.size(); ++i) {
    points.push_back(point_json(came.points[i]));
    points.back()["w2_J_per_m3"] =
        i == 0
            ? Json(nullptr)
            : json_number(second_order_work(came.points[i - 1], came.points[i], came.path.ratio));
  }
  Json negative = nullptr;
  if (found.first_negative) {
    negative = point_json(came.points[*found.first_negative]);
    negative["point"] = *found.first_negative;
  }
  const bool strain_path = came.path.kind == sim::GrainPathKind::strain_path;
  return {{"kind", lab::word(came.path.kind)},
          {"R", strain_path ? Json(came.path.ratio) : Json(nullptr)},
          {"end", lab::word(came.end)},
          {"peak_q", peak_json(found.q, "q_kPa", 1e3)},
          {"peak_eta", peak_json(found.eta, "eta", 1)},
          {"peak_path_stress", peak_json(found.path_stress, "path_stress_kPa", 1e3)},
          {"w2_window_points", work_window(came.path.samples)},
          {"w2_first_negative", std::move(negative)},
          {"kinetic_energy_most_J", json_number(found.most_kinetic_j)},
          {"marks", std::move(marks)},
          {"points", std::move(points)}};
}

Json came_json(const ReportedGrainRest& came) {
  const auto& settling = came.rest.settling;
  return {
      {"held", came.strain_held ? "walls" : "stresses"},
      {"settled", came.rest.settled},
      {"steps", settling.steps},
      {"unbalanced", json_number(settling.unbalanced)},
      {"stress_error_Pa", came.strain_held ? Json(nullptr) : json_number(settling.stress_error_pa)},
      {"path_stress_kPa", json_kPa(came.rest.path_stress_pa)}};
}

/// Null for what a stopped probe does not tell.
Json probe_json(const sim::GrainProbe& p, std::optional<double> angle) {
  Json one = {{"alpha_deg", json_deg(angle)}, {"norm_kPa", json_kPa(p.norm_pa)}};
  one["stopped"] = p.stopped;
  if (p.stopped) return one;
  const auto& w = p.work;
  one.update({{"settled", p.settled},
              {"stress", stress_json(p.stress)},
              {"strain", strain_json(p.strain)},
              {"w2_J_per_m3",
               {{"lagrangian", json_number(w.lagrangian)},
                {"eulerian", json_number(w.eulerian())},
                {"stress_part", json_number(w.stress_part)},
                {"volume_part", json_number(w.volume_part)},
                {"transport_part", json_number(w.transport_part)},
                {"microscopic", json_number(w.microscopic())},
                {"normal_part", json_number(w.normal_part)},
                {"tangential_part", json_number(w.tangential_part)},
                {"non_permanent_part", json_number(w.non_permanent_part)},
                {"fixed_frame", json_number(w.fixed_frame)}}},
              {"boundary_part_J_per_m3", json_number(w.boundary_part)},
              {"w2_normalised", angle ? json_number(w.normalised) : Json(nullptr)},
              {"micro_over_macro", angle ? json_number(micro_over_macro(p)) : Json(nullptr)},
              {"sliding_share", json_number(p.sliding_share)},
              {"non_permanent_share", json_number(w.non_permanent_share())},
              {"kinetic_energy_most_J", json_number(p.most_kinetic_j)},
              {"steps", p.steps},
              {"unbalanced", json_number(p.unbalanced)},
              {"stress_error_Pa", json_number(p.stress_error_pa)}});
  return one;
}

Json ranges_json(const std::vector<AngleRange>& ranges) {
  Json all = Json::array();
  for (const auto& [from, to, directions] : ranges)
    all.push_back(
        {{"from_deg", json_deg(from)}, {"to_deg", json_deg(to)}, {"directions", directions}});
  return all;
}

Json came_json(const ReportedGrainRose& came) {
  const auto& [stress, angles, rose] = came.made;
  const GrainRoseFindings found = rose_findings(rose);
  const bool any = found.made > 0;
  Json probes = Json::array();
  for (std::size_t i = 0; i < rose.probes.size(); ++i)
    probes.push_back(probe_json(rose.probes[i], angles[i]));
  return {
      {"norm_kPa", json_kPa(came.probing.norm_pa)},
      {"stress", stress_json(stress)},
      {"made", found.made},
      {"settled", found.settled},
      {"negative_w2", ranges_json(found.negative)},
      {"least_w2_normalised", json_number(found.least_normalised)},
      {"least_alpha_deg", json_deg(found.least_angle)},
      {"agreement", {{"within", kAgreement}, {"ranges", ranges_json(found.agreeing)}}},
      {"irreversible",
       {{"contacts_above_null_probe", kIrreversible}, {"ranges", ranges_json(found.irreversible)}}},
      {"dynamic",
       {{"times_least_kinetic_energy", kDynamic}, {"ranges", ranges_json(found.dynamic)}}},
      {"unsettled", ranges_json(found.unsettled)},
      {"kinetic_energy_most_J", any ? json_number(found.most_kinetic_j) : Json(nullptr)},
      {"smallest_strain", json_number(found.smallest_strain)},
      {"null_probe_over_smallest", json_number(found.drift)},
      {"null_probe", probe_json(rose.null_probe, {})},
      {"probes", std::move(probes)}};
}

Json came_json(const ReportedPerturbation& came) {
  Json points = Json::array();
  for (const auto& at : came.points)
    points.push_back({{"time_s", json_number(at.time_s)},
                      {"path_stress_kPa", json_kPa(at.path_stress_pa)},
                      {"chi", json_number(at.stress_share)},
                      {"p_kPa", json_kPa(at.p_pa)},
                      {"axial_strain", json_number(at.axial_strain)},
                      {"kinetic_energy_J", json_number(at.kinetic_energy_j)},
                      {"unbalanced", json_number(at.unbalanced)}});
  const auto* last = came.points.empty() ? nullptr : &came.points.back();
  return {{"R", came.how.ratio},
          {"load_step_Pa", came.how.load_step_pa},
          {"kinetic_energy_given_J", came.how.kinetic_energy_j},
          {"floating_share", came.how.floating_share},
          {"seed", came.how.seed},
          {"end", lab::word(came.end)},
          {"time_s", last ? json_number(last->time_s) : Json(nullptr)},
          {"chi", last ? json_number(last->stress_share) : Json(nullptr)},
          {"axial_strain", last ? json_number(last->axial_strain) : Json(nullptr)},
          {"kinetic_energy_most_J", json_number(came.most_kinetic_j)},
          {"grains_hit", came.grains_hit},
          {"points", std::move(points)}};
}

}  // namespace

std::string grain_json(const GrainReport& report) {
  Json stages = Json::array();
  for (const auto& stage : report.stages) {
    Json one = {{"name", stage.name},
                {"action", stage.action},
                {"from", json_text(stage.from)},
                {"steps", stage.steps},
                {"before", measures_json(stage.before)},
                {"after", measures_json(stage.after)}};
    one.update(std::visit([](const auto& came) { return came_json(came); }, stage.came));
    stages.push_back(std::move(one));
  }
  const Json document = {
      {"origin", "simulated"},
      {"format", kGrainReportFormat},
      {"version", kGrainReportVersion},
      {"programme", {{"name", report.programme}, {"source", json_text(report.source)}}},
      {"specimen", specimen_json(report.specimen)},
      {"stages", std::move(stages)}};
  return json_document(document);
}

}  // namespace triax::src
