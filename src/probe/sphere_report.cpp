#include "src/probe/sphere_report.hpp"

#include <fmt/format.h>

#include "src/output/simulated_head.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/probe/sphere_figure.hpp"
#include "src/probe/state_json.hpp"

namespace triax::src {
namespace {

bool of_stress(const SphereProbing& probing) { return probing.kind == sim::ProbeKind::stress; }

study::Json vector_json(const Eigen::Vector3d& v, double unit) {
  return study::Json::array(
      {study::json_number(v(0) / unit), study::json_number(v(1) / unit), study::json_number(v(2) / unit)});
}

study::Json normalised(bool answered, double value) {
  return answered ? study::json_number(value) : study::Json(nullptr);
}

/// Increment and response, scaled to the norm, under the names of stress and strain.
study::Json probe_json(const sim::SphereProbe& probe, const SphereProbing& probing) {
  const Eigen::Vector3d imposed = probing.norm * probe.direction;
  const Eigen::Vector3d response = probing.norm * probe.response;
  const Eigen::Vector3d &stress = of_stress(probing) ? imposed : response,
                        &strain = of_stress(probing) ? response : imposed;
  return {{"polar_deg", study::json_deg(probe.polar)},
          {"azimuth_deg", study::json_deg(probe.azimuth)},
          {"w2_normalised", normalised(probe.answered, probe.normalised)},
          {"w2_Pa", normalised(probe.answered, stress.dot(strain))},
          {"stress_kPa", probe.answered ? vector_json(stress, 1e3) : study::Json(nullptr)},
          {"strain", probe.answered ? vector_json(strain, 1) : study::Json(nullptr)},
          {"answered", probe.answered}};
}

/// Components 11, 22, 33, 12, 13, 23, the shear ones without the factor √2.
study::Json direction_json(const sim::FreeProbe& probe) {
  study::Json components = study::Json::array();
  for (Eigen::Index i = 0; i < 6; ++i)
    components.push_back(study::json_number(probe.direction(i) / (i < 3 ? 1 : std::numbers::sqrt2)));
  return components;
}

study::Json own_json(const ProbedSphere& state) {
  if (!state.own) return nullptr;
  const lab::MeasuredIncrement& own = *state.test->increment;
  return {{"alpha_deg", study::json_deg(own.angle)},
          {"alpha_error_deg", study::json_deg(own.angle_error)},
          {"polar_deg", study::json_deg(state.own->polar)},
          {"azimuth_deg", study::json_deg(state.own->azimuth)},
          {"w2_normalised_measured", study::json_number(own.normalised)},
          {"w2_normalised_error", study::json_number(own.normalised_error)},
          {"w2_normalised_law", normalised(state.own->answered, state.own->normalised)}};
}

std::string own_words(const ProbedSphere& state) {
  const lab::MeasuredIncrement& own = *state.test->increment;
  return fmt::format(
      "{}: α {}° ± {}° of the Rendulic plane, measured W₂ {} ± {}, of the law {}", state.name,
      in_degrees(own.angle, 1), in_degrees(own.angle_error, 1), number(own.normalised, 3),
      number(own.normalised_error, 3),
      number(state.own->answered ? std::optional(state.own->normalised) : std::nullopt, 3));
}

void put_state(const SphereReport& report, const ProbedSphere& state, study::Json& object) {
  const sim::Sphere& sphere = state.sphere;
  object["state"] = state_json(state);
  object["least"] = {
      {"polar_deg", sphere.least.answered ? study::json_deg(sphere.least.polar) : study::Json(nullptr)},
      {"azimuth_deg",
       sphere.least.answered ? study::json_deg(sphere.least.azimuth) : study::Json(nullptr)},
      {"direction",
       sphere.least.answered ? vector_json(sphere.least.direction, 1) : study::Json(nullptr)},
      {"w2_normalised", normalised(sphere.least.answered, sphere.least.normalised)}};
  object["unstable_share"] = sphere.unstable_share;
  object["unstable_regions"] = sphere.regions;
  object["least_of_all_components"] = {
      {"direction", state.least.answered ? direction_json(state.least) : study::Json(nullptr)},
      {"w2_normalised", normalised(state.least.answered, state.least.normalised)}};
  object["own_increment"] = own_json(state);
  object["unanswered_directions"] = sphere.unanswered;
  study::Json probes = study::Json::array();
  for (const auto& probe : sphere.probes) probes.push_back(probe_json(probe, report.probing));
  object["probes"] = std::move(probes);
}

Table state_table(const SphereReport& report) {
  Table table;
  table.columns.push_back({"state", Align::left});
  for (const char* heading : {"p′ (kPa)", "q (kPa)", "η", "e", "unstable (% of directions)",
                              "regions", "least W₂", "in direction (1, 2, 3)", "least of all six"})
    table.columns.push_back({heading, Align::right});
  int count = 0;
  for (const ProbedSphere& state : report.states) {
    const auto& least = state.sphere.least;
    const auto& d = least.direction;
    table.rows.push_back(
        {state.name.empty() ? fmt::format("{}", ++count) : state.name, in_kPa(state.p, 2),
         in_kPa(state.q, 2), number(state.eta(), 4), number(state.void_ratio, 4),
         in_percent(state.sphere.unstable_share, 2), fmt::format("{}", state.sphere.regions),
         number(least.answered ? std::optional(least.normalised) : std::nullopt, 4),
         least.answered
             ? fmt::format("{}, {}, {}", number(d(0), 3), number(d(1), 3), number(d(2), 3))
             : kUnknown,
         number(state.least.answered ? std::optional(state.least.normalised) : std::nullopt, 4)});
  }
  return table;
}

std::string probing_words(const SphereProbing& probing) {
  return fmt::format("{} of {:g}{}, {} rings of {} directions, by the rate at the state",
                     of_stress(probing) ? "stress" : "strain",
                     of_stress(probing) ? probing.norm / 1e3 : probing.norm,
                     of_stress(probing) ? " kPa" : "", probing.rings, 2 * probing.rings);
}

}  // namespace

ProbedSphere probe_sphere_of(const lab::MaterialSet& material,
                             const study::StateToProbe<sim::Tensor>& what,
                             const SphereProbing& probing) {
  ProbedSphere probed{study::head_of(material, what), {}, {}, {}};
  const sim::IncrementalResponse<sim::Tensor> response(*material.material.tensor, what.state);
  probed.sphere = sim::probe_sphere(response, probing.kind, probing.rings);
  probed.least = sim::least_of_all_directions(response, probing.kind, probed.sphere.least);
  if (what.test && what.test->increment) {
    const double angle = what.test->increment->angle,
                 radial = std::cos(angle) / std::numbers::sqrt2;
    probed.own =
        sim::probe_direction(response, sim::ProbeKind::stress, {std::sin(angle), radial, radial});
  }
  return probed;
}

std::string sphere_json(const SphereReport& report) {
  const bool stress = of_stress(report.probing);
  study::Json document = {
      {"origin", "simulated"},
      {"material", study::json_material(report.material)},
      {"probing",
       {{"kind", stress ? "stress" : "strain"},
        {"plane", "3d"},
        {"norm_kPa", stress ? study::json_kPa(report.probing.norm) : study::Json(nullptr)},
        {"norm_strain", stress ? study::Json(nullptr) : study::Json(report.probing.norm)},
        {"step_deg", 180.0 / report.probing.rings},
        {"finite", false},
        {"norms", "full"}}},
      {"path", study::json_text(report.path)}};
  study::Json warnings = report.warnings;
  if (!report.many && report.states.size() == 1) {
    put_state(report, report.states.front(), document);
    for (const auto& warning : report.states.front().all_warnings()) warnings.push_back(warning);
  } else {
    study::Json states = study::Json::array();
    for (const ProbedSphere& state : report.states) {
      study::Json one = study::Json::object();
      put_state(report, state, one);
      one["warnings"] = state.all_warnings();
      states.push_back(std::move(one));
    }
    document["states"] = std::move(states);
  }
  document["warnings"] = std::move(warnings);
  return study::json_document(document);
}

std::string sphere_text(const SphereReport& report) {
  std::string out =
      simulated_head("Second-order work in every direction of space", report.material);
  out += fact("probes", probing_words(report.probing));
  out += fact("path", report.path);
  out += '\n' + indented(to_text(state_table(report)));
  out +=
      "  directions of principal increments along the axes of the state; the last column is over\n"
      "  all six components, rotations of the axes included\n\n";
  for (const ProbedSphere& state : report.states)
    if (state.own) out += fact("own", own_words(state));
  std::vector<const study::StateHead*> heads;
  for (const ProbedSphere& state : report.states) heads.push_back(&state);
  for (const auto& warning : report.warnings) out += fact("warning", warning);
  for (const auto& warning : study::warnings_of(heads)) out += fact("warning", warning);
  return without_controls(out);
}

FigureData sphere_data(const SphereReport& report) {
  const bool stress = of_stress(report.probing);
  FigureData data{
      .title = "second-order work in every direction of space, " + report.material.name,
      .origin = "simulated",
      .remarks = {"law: " + report.material.law->title, "probes: " + probing_words(report.probing)},
      .columns = {{"state", ""},
                  {"p_eff_kPa", "kPa"},
                  {"q_kPa", "kPa"},
                  {"void_ratio", ""},
                  {"polar_deg", "°"},
                  {"azimuth_deg", "°"},
                  {"w2_normalised", ""}},
      .rows = {}};
  for (const char* axis : {"1", "2", "3"})
    data.columns.push_back(
        {fmt::format("imposed_{}{}", axis, stress ? "_kPa" : ""), stress ? "kPa" : ""});
  for (const char* axis : {"1", "2", "3"})
    data.columns.push_back(
        {fmt::format("response_{}{}", axis, stress ? "" : "_kPa"), stress ? "" : "kPa"});
  const double imposed_unit = stress ? 1e3 : 1, response_unit = stress ? 1 : 1e3;
  for (std::size_t i = 0; i < report.states.size(); ++i) {
    const ProbedSphere& state = report.states[i];
    for (const auto& probe : state.sphere.probes) {
      std::vector<std::optional<double>> row = {static_cast<double>(i + 1),
                                                state.p / 1e3,
                                                state.q / 1e3,
                                                state.void_ratio,
                                                sim::degrees(probe.polar),
                                                sim::degrees(probe.azimuth),
                                                std::nullopt};
      if (probe.answered) row.back() = probe.normalised;
      for (int k = 0; k < 3; ++k)
        row.emplace_back(report.probing.norm * probe.direction(k) / imposed_unit);
      for (int k = 0; k < 3 && probe.answered; ++k)
        row.emplace_back(report.probing.norm * probe.response(k) / response_unit);
      row.resize(data.columns.size());
      data.rows.push_back(std::move(row));
    }
  }
  return data;
}

Drawing sphere_drawing(const SphereReport& report) {
  if (report.states.empty()) return {};
  const ProbedSphere& state = report.states.back();
  std::vector<SphereDirection> directions;
  for (const auto& probe : state.sphere.probes)
    directions.push_back({probe.direction, probe.response, probe.answered, probe.normalised});
  return sphere_figure(directions,
                       {.material = report.material.name,
                        .state = fmt::format("p′ = {:.4g} kPa, q = {:.4g} kPa, e = {:.4g}",
                                             state.p / 1e3, state.q / 1e3, state.void_ratio),
                        .plane = sim::ProbePlane::axisymmetric,
                        .kind = report.probing.kind});
}

}  // namespace triax::src
