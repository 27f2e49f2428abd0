// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/identities.hpp"

#include <array>
#include <tuple>
#include <utility>

#include "lab/intake/course_evidence.hpp"
#include "lab/intake/relation_evidence.hpp"

namespace triax::lab {
namespace {

constexpr const char* kQ = "deviator_stress";
constexpr const char* kUncorrected = "deviator_stress_uncorrected";
constexpr const char* kT = "half_deviator_stress";
constexpr const char* kP = "mean_effective_stress";
constexpr const char* kS = "mean_effective_stress_2d";
constexpr const char* kTotalP = "mean_stress";
constexpr const char* kU = "pore_pressure";
constexpr const char* kExcess = "excess_pore_pressure";
constexpr const char* kAxial = "axial_stress";
constexpr const char* kRadial = "radial_stress";
constexpr const char* kCell = "cell_pressure";
constexpr const char* kEffectiveAxial = "effective_axial_stress";
constexpr const char* kEffectiveRadial = "effective_radial_stress";
constexpr const char* kStrain = "axial_strain";
constexpr const char* kDisplacement = "axial_displacement";
constexpr const char* kVolume = "volumetric_strain";
constexpr const char* kRadialStrain = "radial_strain";

using Terms = std::vector<std::pair<const char*, double>>;
using QuantityNames = std::vector<std::string>;

Identity sum(std::string text, const Terms& terms) {
  Identity out{.text = std::move(text), .quantities = {}, .unless = {}, .evidence = sum_evidence};
  for (const auto& [name, coefficient] : terms) {
    out.quantities.emplace_back(name);
    out.coefficients.push_back(coefficient);
  }
  return out;
}

/// The cell pressure is usually held, so that a test in which it is not is weak evidence against
/// it.
Identity constant(std::string text, const Terms& terms, QuantityNames unless, double lowest) {
  Identity out = sum(std::move(text), terms);
  out.unless = std::move(unless);
  out.is_constant = true;
  out.lowest = lowest;
  return out;
}

using Evidence = decltype(Identity::evidence);

Identity proportion(std::string text, QuantityNames quantities, Evidence evidence, double from,
                    double to, double lowest, double highest) {
  return {.text = std::move(text),
          .quantities = std::move(quantities),
          .unless = {},
          .evidence = evidence,
          .lowest = lowest,
          .highest = highest,
          .from = from,
          .to = to};
}

Identity course(std::string text, QuantityNames quantities, Evidence evidence, double lowest,
                double highest, double factor = 1) {
  return {.text = std::move(text),
          .quantities = std::move(quantities),
          .unless = {},
          .evidence = evidence,
          .lowest = lowest,
          .highest = highest,
          .factor = factor};
}

void add_stresses(std::vector<Identity>& all) {
  struct Pair {
    const char *axial, *radial, *text;
  };
  for (const Pair& pair : {Pair{kAxial, kRadial, "σ1 − σ3"}, Pair{kAxial, kCell, "σ1 − σ_c"},
                           Pair{kEffectiveAxial, kEffectiveRadial, "σ1′ − σ3′"}}) {
    all.push_back(
        sum(std::string("q = ") + pair.text, {{kQ, 1}, {pair.axial, -1}, {pair.radial, 1}}));
    all.push_back(sum(std::string("t = half of ") + pair.text,
                      {{kT, 2}, {pair.axial, -1}, {pair.radial, 1}}));
  }
  all.push_back(sum("q = 2 t", {{kQ, 1}, {kT, -2}}));
  all.push_back(sum("q = uncorrected q − correction",
                    {{kQ, 1}, {kUncorrected, -1}, {"membrane_and_drain_correction", 1}}));
  for (const char* total : {kRadial, kCell}) {
    all.push_back(sum("σ3 = σ3′ + u", {{total, 1}, {kEffectiveRadial, -1}, {kU, -1}}));
    all.push_back(sum("p = σ3 + q/3", {{kTotalP, 1}, {total, -1}, {kQ, -1. / 3}}));
    all.push_back(sum("p′ = σ3 − u + q/3", {{kP, 1}, {total, -1}, {kU, 1}, {kQ, -1. / 3}}));
    all.push_back(sum("p′ = σ3 − u + 2 t/3", {{kP, 1}, {total, -1}, {kU, 1}, {kT, -2. / 3}}));
    all.push_back(sum("s′ = σ3 − u + q/2", {{kS, 1}, {total, -1}, {kU, 1}, {kQ, -0.5}}));
    all.push_back(sum("s′ = σ3 − u + t", {{kS, 1}, {total, -1}, {kU, 1}, {kT, -1}}));
  }
  all.push_back(sum("σ1 = σ1′ + u", {{kAxial, 1}, {kEffectiveAxial, -1}, {kU, -1}}));
  all.push_back(sum("p = p′ + u", {{kTotalP, 1}, {kP, -1}, {kU, -1}}));
  all.push_back(constant("u − Δu is constant", {{kU, 1}, {kExcess, -1}}, {}, -4));
}

/// A mean stress and a deviator with the coefficient that gives σ3 as their difference.
struct PathDefinition {
  const char *mean, *deviator;
  double fraction;
  const char* text;
};
constexpr auto kPaths = std::to_array<PathDefinition>({{kP, kQ, 1. / 3, "p′ − q/3"},
                                                       {kP, kT, 2. / 3, "p′ − 2 t/3"},
                                                       {kS, kQ, 0.5, "s′ − q/2"},
                                                       {kS, kT, 1, "s′ − t"}});

void add_paths(std::vector<Identity>& all) {
  for (const PathDefinition& path : kPaths)
    all.push_back(sum(std::string("σ3′ = ") + path.text,
                      {{path.mean, 1}, {kEffectiveRadial, -1}, {path.deviator, -path.fraction}}));
  const QuantityNames totals{kRadial, kCell};
  for (const char* u : {kU, kExcess}) {
    const std::string pressure = u == kU ? "u" : "Δu";
    const QuantityNames unless = u == kU ? totals : QuantityNames{};
    all.push_back(constant("σ3′ + " + pressure + " is constant", {{kEffectiveRadial, 1}, {u, 1}},
                           unless, -2));
    for (const PathDefinition& path : kPaths) {
      QuantityNames stronger = unless;
      stronger.emplace_back(kEffectiveRadial);
      all.push_back(constant(path.text + (" + " + pressure) + " is constant",
                             {{path.mean, 1}, {path.deviator, -path.fraction}, {u, 1}},
                             std::move(stronger), -4));
    }
  }
  for (const PathDefinition& path : kPaths)
    all.push_back(constant(std::string(path.text) + " is constant",
                           {{path.mean, 1}, {path.deviator, -path.fraction}},
                           {kU, kExcess, kEffectiveRadial}, 0));
  for (const auto& [deviator, fraction] : {std::pair{kQ, 1. / 3}, std::pair{kT, 2. / 3}})
    all.push_back(constant("p − q/3 is constant", {{kTotalP, 1}, {deviator, -fraction}},
                           {kRadial, kCell, kEffectiveRadial}, 0));
  all.push_back(course("s′ and t", {kS, kT}, definition_evidence, 0, 1.5));
  for (const auto& [mean, deviator] : {std::pair{kS, kQ}, std::pair{kP, kT}})
    all.push_back(course("definitions are not mixed", {mean, deviator}, mixture_evidence, -3, 0));
  all.push_back(
      course("both effective", {kEffectiveAxial, kEffectiveRadial}, definition_evidence, 0, 1.5));
  all.push_back(
      course("total beside effective", {kAxial, kEffectiveRadial}, mixture_evidence, -3, 0));
  all.back().unless = {kEffectiveAxial};
}

void add_strains(std::vector<Identity>& all) {
  all.push_back(sum("ε_v = ε_1 + 2 ε_3", {{kVolume, 1}, {kStrain, -1}, {kRadialStrain, -2}}));
  all.push_back(sum("ε_q = ε_1 − ε_v/3", {{"shear_strain", 1}, {kStrain, -1}, {kVolume, 1. / 3}}));
  all.push_back(proportion("displacement = height · ε_1", {kDisplacement, kStrain}, height_evidence,
                           20, 700, -4, 8));
  all.push_back(proportion("height = H0 (1 − ε_1)", {"specimen_height", kStrain},
                           current_height_evidence, 20, 700, -4, 8));
  all.back().factor = -1;
  all.push_back(proportion("area = A0 / (1 − ε_1)", {"current_area", kStrain}, area_evidence, 300,
                           9e4, -1, 2));
  all.push_back(
      proportion("ΔV = V0 · ε_v", {"volume_change", kVolume}, direct_evidence, 1e3, 1e8, -1, 4));
  all.push_back(
      proportion("V_b = −V0 · ε_v", {"back_volume", kVolume}, direct_evidence, 1e3, 1e8, -1, 4));
  all.back().factor = -1;
  all.push_back(proportion("e = (1 + e0) (1 − ε_v) − 1", {"void_ratio", kVolume}, direct_evidence,
                           1.1, 5, -1, 4));
  all.back().factor = -1;
}

void add_forces(std::vector<Identity>& all) {
  all.push_back(proportion("q = F / A", {"axial_force", kQ, "current_area"},
                           force_over_area_evidence, 0.8, 1.25, -1, 8));
  all.back().unless = {kUncorrected};
  all.push_back(proportion("uncorrected q = F / A", {"axial_force", kUncorrected, "current_area"},
                           force_over_area_evidence, 0.8, 1.25, -1, 8));
  all.push_back(proportion("t = F / (2 A)", {"axial_force", kT, "current_area"},
                           force_over_area_evidence, 0.8, 1.25, -1, 8));
  all.back().factor = 2;
  for (const auto& [stress, factor, text] : {std::tuple{kQ, 1.0, "q = F (1 − ε_1) / A0"},
                                             std::tuple{kT, 2.0, "2 t = F (1 − ε_1) / A0"}}) {
    all.push_back(proportion(text, {"axial_force", stress, kStrain}, force_over_strain_evidence,
                             3e-4, 0.08, -1, 3));
    all.back().factor = factor;
  }
  all.push_back(proportion("F = reading of the ring · factor", {"axial_force", "force_reading"},
                           direct_evidence, 1e-9, 1e9, -1, 3));
  all.push_back(
      proportion("η = q / p′", {"stress_ratio", kQ, kP}, quotient_evidence, 0.95, 1.05, -4, 8));
  all.push_back(proportion("σ1′ / σ3′",
                           {"principal_stress_ratio", kEffectiveAxial, kEffectiveRadial},
                           quotient_evidence, 0.95, 1.05, -4, 8));
}

/// Beside the axis if there is one.
void add_first_contraction(std::vector<Identity>& all, const char* volume, double sign) {
  const auto add = [&](QuantityNames quantities, QuantityNames unless) {
    all.push_back(course("the specimen contracts first", std::move(quantities),
                         first_contraction_evidence, -2, 2, sign));
    all.back().unless = std::move(unless);
  };
  add({volume, kStrain}, {});
  add({volume, kDisplacement}, {kStrain});
  add({volume}, {kStrain, kDisplacement});
}

void add_courses(std::vector<Identity>& all) {
  for (const char* deformation : {kStrain, kDisplacement})
    for (const char* load : {kQ, kT, "axial_force"})
      all.push_back(course("load and deformation grow together", {deformation, load},
                           common_direction_evidence, -1.5, 1.5));
  for (const char* load : {kQ, kT, "axial_force", kStrain})
    all.push_back(course("compression is positive", {load}, compression_evidence, -0.5, 0.5));
  for (const char* stress : {kEffectiveAxial, kEffectiveRadial, kP, kS, kAxial, kRadial, kCell})
    all.push_back(course("soil takes no tension", {stress}, no_tension_evidence, -2, 0));
  for (const char* deviator : {kQ, kT})
    all.push_back(course("the deviator begins at 0", {deviator}, start_at_zero_evidence, -1.5, 0));
  for (const auto& [volume, sign] :
       {std::pair{kVolume, 1.0}, std::pair{"volume_change", 1.0}, std::pair{"back_volume", -1.0}})
    add_first_contraction(all, volume, sign);
  for (const char* total : {kRadial, kCell})
    all.push_back(course("σ3 is above u", {total, kU}, order_evidence, -6, 0.5));
  all.push_back(
      course("u begins at the back pressure", {kU, "back_pressure"}, same_start_evidence, -3, 1));
  all.push_back(course("Δu begins at 0", {kExcess}, start_at_zero_evidence, -4, 1.5));
  all.push_back(course("u begins above 0", {kU}, start_above_zero_evidence, -4, 0.5));
  all.push_back(course("σ1′/σ3′ begins above 0", {"principal_stress_ratio"},
                       start_above_zero_evidence, -4, 0.5));
  all.push_back(course("strain is 1.5 to 100 %", {kStrain}, strain_range_evidence, -3, 0));
  all.push_back(
      course("displacement reaches 0.5 mm", {kDisplacement}, displacement_range_evidence, -3, 0));
  all.push_back(
      course("volume change reaches 50 mm³", {"volume_change"}, volume_range_evidence, -3, 0));
  all.push_back(course("time runs", {"time"}, one_direction_evidence, -6, 1.5));
  all.push_back(course("counts the rows", {"reading_number"}, row_numbers_evidence, -6, 4));
  for (const char* counter : {"stage", "cycle"})
    all.push_back(course("counts", {counter}, counter_evidence, -6, 3));
  for (const char* held : {kCell, kRadial})
    all.push_back(course("the cell pressure is held", {held}, held_value_evidence, -1, 1));
}

}  // namespace

const std::vector<Identity>& identities() {
  static const std::vector<Identity> all = [] {
    std::vector<Identity> out;
    add_stresses(out);
    add_paths(out);
    add_strains(out);
    add_forces(out);
    add_courses(out);
    return out;
  }();
  return all;
}

}  // namespace triax::lab
