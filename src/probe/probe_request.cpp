// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/probe_request.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/paths/path_reader.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"

namespace triax::src {
namespace {

/// The path of the options with the material and the void ratio that take the place of its own.
lab::PathDescription described(const ProbeOptions& o) {
  lab::PathDescription description = lab::load_path(o.path);
  if (!o.material.name.empty())
    description.material = chosen_material(o.material);
  else
    for (const auto& [key, value] : key_values(o.material.sets, "hardening_factor=2"))
      description.material = lab::with_parameter(description.material, key, value);
  if (o.material.void_ratio)
    lab::change_setting(description, "void_ratio", fmt::format("{}", *o.material.void_ratio));
  if (o.plane == "axisymmetric" && !std::holds_alternative<lab::TriaxialPath>(description.path))
    throw lab::BadInput(
        description.source, 0,
        "the path uses the full tensor and is not axisymmetric; use --plane plane-strain");
  return description;
}

study::GivenStates given_states(const ProbeOptions& o, const lab::MaterialSet& material) {
  study::GivenStates states{.stress_kPa = {},
                            .void_ratio = chosen_void_ratio(o.material, material)};
  if (!o.stress_kPa.empty())
    states.stress_kPa.emplace_back(o.stress_kPa.front(), o.stress_kPa[1], o.stress_kPa.back());
  const double p = o.p_kPa.value_or(0);
  for (const double eta : o.eta) states.stress_kPa.push_back(study::triaxial_stress(p, eta * p));
  for (const double q : o.q_kPa) states.stress_kPa.push_back(study::triaxial_stress(p, q));
  return states;
}

study::MeasuredStates measured_states(const ProbeOptions& o, const lab::MaterialSet& material) {
  if (o.material.void_ratio) chosen_void_ratio(o.material, material);
  return {.db = o.db,
          .tests = o.tests,
          .at = o.at.empty() ? "collapse" : o.at,
          .void_ratio = o.material.void_ratio};
}

/// Material and states of a request, be it one of a plane or of space.
template <class Request>
void put_states(const ProbeOptions& o, Request& request) {
  check_state_options(o);
  if (!o.path.empty()) {
    auto path = described(o);
    request.material = path.material;
    request.states = study::StatesOfPath{std::move(path), o.every};
    return;
  }
  request.material = chosen_material(o.material);
  if (o.tests.empty())
    request.states = given_states(o, request.material);
  else
    request.states = measured_states(o, request.material);
}

}  // namespace

study::ProbeRequest probe_request(const ProbeOptions& o) {
  study::ProbeRequest request{.probing = checked_probing(o), .figures = !o.output.empty()};
  put_states(o, request);
  return request;
}

study::SphereRequest sphere_request(const ProbeOptions& o) {
  study::SphereRequest request{.probing = checked_sphere(o)};
  put_states(o, request);
  return request;
}

study::StrainPathsRequest strain_paths_request(const ProbeOptions& o) {
  check_strain_path_options(o);
  const auto material = chosen_material(o.material);
  return {.material = material,
          .p = 1e3 * *o.p_kPa,
          .void_ratio = chosen_void_ratio(o.material, material),
          .R = o.strain_paths,
          .axial_strain = o.axial_strain.value_or(kUsualAxialStrain)};
}

std::vector<std::string> files_read(const ProbeOptions& o) {
  std::vector<std::string> files;
  if (!o.path.empty()) files = lab::load_path(o.path).files;
  if (!o.tests.empty()) files = database_files(o.db);
  if (!o.material.file.empty()) files.push_back(o.material.file);
  return files;
}

}  // namespace triax::src
