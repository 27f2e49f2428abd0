// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/implied_domain_json.hpp"

#include "sim/mechanics/axisymmetric.hpp"

namespace triax::study {
namespace {

std::optional<double> in_degrees(const std::optional<double>& rad) {
  return rad ? std::optional(sim::degrees(*rad)) : std::nullopt;
}

Json ratio_json(const Implied& of) {
  return {{"value", json_number(of.best)},
          {"low", json_number(of.low)},
          {"high", json_number(of.high)},
          {"share", json_number(of.share)}};
}

Json angle_json(const Implied& of) {
  return ratio_json({in_degrees(of.best), in_degrees(of.low), in_degrees(of.high), of.share});
}

Json boundaries_json(const std::vector<ImpliedBoundary>& side) {
  Json all = Json::array();
  for (const ImpliedBoundary& at : side)
    all.push_back({{"p_eff_kPa", json_kPa(at.p)},
                   {"first_unstable", ratio_json(at.first_unstable)},
                   {"alpha_deg", angle_json(at.first_angle)},
                   {"isotropic_unloading", ratio_json(at.isotropic_unloading)},
                   {"limit", ratio_json(at.limit)}});
  return all;
}

}  // namespace

Json implied_domain_json(const ImpliedDomain& d) {
  Json cones = Json::array();
  for (const ImpliedCone& cone : d.cones)
    cones.push_back({{"p_eff_kPa", json_kPa(cone.p)},
                     {"q_kPa", json_kPa(cone.q)},
                     {"eta", json_number(cone.q / cone.p)},
                     {"from_deg", angle_json(cone.from)},
                     {"to_deg", angle_json(cone.to)},
                     {"opening_deg", angle_json(cone.opening)}});
  return {{"void_ratio", json_number(d.void_ratio)},
          {"of_collapsed_tests", d.of_collapsed},
          {"confidence", d.confidence},
          {"draws", d.draws},
          {"asked", d.asked},
          {"refused", d.refused},
          {"none", json_text(d.none)},
          {"compression", boundaries_json(d.compression)},
          {"extension", boundaries_json(d.extension)},
          {"cones", std::move(cones)}};
}

}  // namespace triax::study
