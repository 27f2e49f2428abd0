// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/specimen_phases.hpp"

#include <cmath>
#include <numbers>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

constexpr double kWaterDensity = 1000;  // kg/m³

using Value = std::optional<double>;

Value if_known(double value) { return std::isfinite(value) ? Value(value) : std::nullopt; }

/// What follows from the void ratio, the dry mass, G_s and what is said of the water.
void complete(SpecimenPhase& phase, const lab::SpecimenInfo& specimen, const Value& dry_mass,
              bool saturated) {
  const auto& gs = specimen.specific_gravity;
  Value volume;
  if (phase.height_m && phase.diameter_m)
    volume = std::numbers::pi / 4 * *phase.diameter_m * *phase.diameter_m * *phase.height_m;
  if (gs && phase.void_ratio)
    phase.dry_density = *gs * kWaterDensity / (1 + *phase.void_ratio);
  else if (dry_mass && volume)
    phase.dry_density = *dry_mass / *volume;
  if (!phase.void_ratio && gs && phase.dry_density)
    phase.void_ratio = *gs * kWaterDensity / *phase.dry_density - 1;
  Value solids = dry_mass;
  if (!solids && phase.dry_density && volume) solids = *phase.dry_density * *volume;
  if (!phase.water_content && phase.mass_kg && solids)
    phase.water_content = *phase.mass_kg / *solids - 1;
  if (!phase.water_content && saturated && gs && phase.void_ratio) {
    phase.water_content = *phase.void_ratio / *gs;
    phase.saturation_is_assumed = true;
  }
  if (!phase.mass_kg && phase.water_content && solids)
    phase.mass_kg = *solids * (1 + *phase.water_content);
  if (phase.mass_kg && volume) phase.bulk_density = *phase.mass_kg / *volume;
  if (phase.water_content && gs && phase.void_ratio && *phase.void_ratio > 0)
    phase.saturation = *phase.water_content * *gs / *phase.void_ratio;
}

}  // namespace

SpecimenPhases specimen_phases(const db::StoredTest& test, const SheetValues& values,
                               const SheetWords& words) {
  const auto& specimen = test.header.specimen;
  const auto& start = test.summary.consolidation;
  const auto grams = [&](const char* key) {
    const auto g = number_of(words, key);
    return g ? Value(*g * 1e-3) : std::nullopt;
  };
  const auto share = [&](const char* key) {
    const auto percent = number_of(words, key);
    return percent ? Value(*percent / 100) : std::nullopt;
  };
  Value dry_mass = specimen.dry_mass_kg ? specimen.dry_mass_kg : grams("dry_mass_after_g");
  SpecimenPhases phases;
  phases.built = {.height_m = specimen.height_m,
                  .diameter_m = specimen.diameter_m,
                  .mass_kg = grams("mass_g"),
                  .water_content = share("water_content_pct"),
                  .void_ratio = specimen.void_ratio};
  if (!dry_mass && phases.built.mass_kg && phases.built.water_content)
    dry_mass = *phases.built.mass_kg / (1 + *phases.built.water_content);
  complete(phases.built, specimen, dry_mass, false);
  phases.start = {
      .height_m = start.height_m, .diameter_m = start.diameter_m, .void_ratio = void_ratio(test)};
  if (!start.void_ratio && !specimen.consolidated_void_ratio) phases.start.void_ratio.reset();
  complete(phases.start, specimen, dry_mass, true);
  phases.end = {.mass_kg = grams("mass_after_g"),
                .water_content = share("water_content_after_pct")};
  if (values.end) {
    const auto& s = values.end->state;
    if (start.height_m) phases.end.height_m = if_known(*start.height_m * (1 - s.strain.axial));
    if (std::isfinite(s.area_m2))
      phases.end.diameter_m = std::sqrt(4 / std::numbers::pi * s.area_m2);
    phases.end.void_ratio = if_known(s.void_ratio);
  }
  complete(phases.end, specimen, dry_mass, true);
  return phases;
}

}  // namespace triax::study
