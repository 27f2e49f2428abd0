// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/load_corrections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lab/base/text.hpp"

namespace triax::study {
namespace {

constexpr double kGravity = 9.81;     // m/s²
constexpr double kFullStrain = 0.02;  // from which strips carry all they can
constexpr double kMostCovered = 0.5;  // of the circumference

struct DrainRow {
  double diameter_m, stress_pa;
};
constexpr std::array<DrainRow, 5> kTable2 = {
    {{0.038, 10e3}, {0.050, 7e3}, {0.070, 5e3}, {0.100, 3.5e3}, {0.150, 2.5e3}}};

double share_of_strain(double axial_strain) {
  return std::clamp(axial_strain / kFullStrain, 0.0, 1.0);
}

std::optional<double> number_in(const SheetWords& words, std::string_view key, double unit) {
  const auto value = number_of(words, key);
  return value ? std::optional(*value * unit) : std::nullopt;
}

void find_side_drains(LoadCorrections& found, const db::StoredTest& test, const SheetValues& values,
                      const SheetWords& words) {
  const auto said = lab::folded(word_of(words, "side_drains"));
  const bool sides =
      values.options.boundary_is_said && values.options.drained_at >= DrainageBoundary::sides;
  if (!sides && !says_yes(words, "side_drains") && said != "spiral" && said != "vertical") {
    found.why_no_side_drains = "none given";
    return;
  }
  if (said == "spiral") {
    found.why_no_side_drains = "spirals carry no load";
    return;
  }
  if (values.failure->state.q < 0) {
    found.why_no_side_drains = "strips carry no load in extension";
    return;
  }
  const auto& diameter = test.summary.consolidation.diameter_m;
  if (!diameter || !(*diameter > 0)) {
    found.why_no_side_drains =
        "side drains are given, but the diameter at the start of shear is unknown";
    return;
  }
  SideDrains drains{.diameter_m = *diameter};
  drains.load_n_per_m = number_in(words, "drain_load_kN_m", 1e3);
  drains.cover = std::clamp(number_in(words, "drain_cover_pct", 1e-2).value_or(kMostCovered), 0.0,
                            kMostCovered);
  const double strain = values.failure->state.strain.axial;
  drains.taken_off_pa =
      drains.load_n_per_m ? side_drain_stress(*drains.load_n_per_m, drains.cover, *diameter, strain)
                          : side_drain_stress(*diameter, strain);
  found.side_drains = drains;
}

void find_piston(LoadCorrections& found, const SheetValues& values, const SheetWords& words) {
  const bool outside = lab::folded(word_of(words, "load_cell")) == "outside";
  const auto friction = number_of(words, "piston_friction_N");
  const auto diameter = number_in(words, "piston_diameter_mm", 1e-3);
  if (!outside && !friction) {
    found.why_no_piston = "assumed: load cell inside the cell";
    return;
  }
  const auto& failure = *values.failure;
  if (outside && !diameter) {
    found.why_no_piston = "load cell outside the cell, but piston_diameter_mm is missing";
    return;
  }
  Piston piston{.friction_n = friction.value_or(0), .specimen_area_m2 = failure.state.area_m2};
  if (failure.state.q < 0) piston.friction_n = -piston.friction_n;  // the piston goes up
  if (outside) {
    piston.area_m2 = std::numbers::pi / 4 * *diameter * *diameter;
    piston.weight_n = kGravity * number_in(words, "piston_mass_g", 1e-3).value_or(0);
    piston.cell_pressure_pa = failure.cell_pressure;
    piston.zero_pressure_pa =
        number_in(words, "load_zero_kPa", 1e3).value_or(values.start->cell_pressure);
  }
  piston.taken_off_pa =
      (piston.friction_n + piston.area_m2 * (piston.cell_pressure_pa - piston.zero_pressure_pa) -
       piston.weight_n) /
      piston.specimen_area_m2;
  if (std::isfinite(piston.taken_off_pa))
    found.piston = piston;
  else
    found.why_no_piston = "the cell pressure or the area at failure is unknown";
}

}  // namespace

double side_drain_stress(double load_n_per_m, double cover, double diameter_m,
                         double axial_strain) {
  return load_n_per_m * cover * 4 / diameter_m * share_of_strain(axial_strain);
}

double side_drain_stress(double diameter_m, double axial_strain) {
  const auto above = std::ranges::find_if(
      kTable2, [&](const DrainRow& row) { return row.diameter_m >= diameter_m; });
  const double share = share_of_strain(axial_strain);
  if (above == kTable2.begin()) return above->stress_pa * share;
  const auto& low = *(above - 1);
  if (above == kTable2.end()) return low.stress_pa * share;
  const double part = (diameter_m - low.diameter_m) / (above->diameter_m - low.diameter_m);
  return std::lerp(low.stress_pa, above->stress_pa, part) * share;
}

double LoadCorrections::taken_off_pa() const {
  return (side_drains ? side_drains->taken_off_pa : 0) + (piston ? piston->taken_off_pa : 0);
}

std::optional<double> LoadCorrections::q_left_pa(const SheetValues& values) const {
  if (!values.failure || (!side_drains && !piston)) return std::nullopt;
  return values.failure->state.q - taken_off_pa();
}

LoadCorrections load_corrections(const db::StoredTest& test, const SheetValues& values,
                                 const SheetWords& words) {
  LoadCorrections found;
  if (!test.header.is_raw()) {
    found.why_no_side_drains = found.why_no_piston = "unknown: the record was already reduced";
    return found;
  }
  if (!values.failure || !values.start) {
    found.why_no_side_drains = found.why_no_piston = "no failure";
    return found;
  }
  find_side_drains(found, test, values, words);
  find_piston(found, values, words);
  return found;
}

}  // namespace triax::study
