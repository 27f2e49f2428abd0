// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/strain_paths_json.hpp"

#include "src/study/json_parts.hpp"

namespace triax::src {
namespace {

study::Json point_json(const std::optional<sim::StrainPathPoint>& at) {
  if (!at) return nullptr;
  return {{"axial_strain", study::json_number(at->axial_strain)},
          {"control_stress_kPa", study::json_kPa(at->control_stress)},
          {"p_eff_kPa", study::json_kPa(at->p)},
          {"q_kPa", study::json_kPa(at->q)},
          {"eta", study::json_number(at->eta())},
          {"void_ratio", study::json_number(at->void_ratio)},
          {"w2_normalised", study::json_number(at->normalised_work)}};
}

}  // namespace

std::string strain_paths_json(const study::StrainPathsResult& result) {
  study::Json document = {{"origin", "simulated"},
                          {"material", study::json_material(result.material)},
                          {"start",
                           {{"p_eff_kPa", study::json_kPa(result.p)},
                            {"q_kPa", 0.0},
                            {"void_ratio", study::json_number(result.void_ratio)}}},
                          {"axial_strain", result.axial_strain}};
  study::Json paths = study::Json::array();
  for (const auto& path : result.paths) {
    study::Json points = study::Json::array();
    for (const auto& point : path.points) points.push_back(point_json(point));
    paths.push_back({{"R", path.R},
                     {"peak", point_json(path.peak)},
                     {"first_unstable", point_json(path.first_unstable)},
                     {"vanished", point_json(path.vanished)},
                     {"message", study::json_text(path.message)},
                     {"points", std::move(points)}});
  }
  document["strain_paths"] = std::move(paths);
  document["warnings"] = result.warnings;
  return study::json_document(document);
}

}  // namespace triax::src
