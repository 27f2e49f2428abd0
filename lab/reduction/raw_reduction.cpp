// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/raw_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

constexpr double kWaterDensity = 1000;  // kg/m³

double required(const std::optional<double>& value, const RecordHeader& header, const char* what,
                const std::string& key) {
  if (!value)
    throw MissingKey(
        header.source, key, what, key.substr(key.rfind('_') + 1),
        fmt::format("the record has raw channels but the {} is missing; give it with --set {}=...",
                    what, key));
  if (!(*value > 0))
    throw BadInput(header.source, 0, fmt::format("the {} must be positive ({})", what, key));
  return *value;
}

}  // namespace

RawReduction::RawReduction(const RecordHeader& header, const ReductionOptions& options)
    : specimen_(header.specimen), stages_(header.stages), options_(options) {
  if (!header.is_raw()) return;
  if (!header.has(Quantity::pore_pressure) && !header.has(Quantity::back_pressure) &&
      !header.is_total_stress())
    throw BadInput(header.source, 0,
                   fmt::format("a channel is missing: effective stresses need {} (or {}); for an "
                               "unconsolidated undrained test give --set test.programme=UU",
                               heading(Quantity::pore_pressure), heading(Quantity::back_pressure)));
  const double height =
      required(specimen_.height_m, header, "height of the specimen", "specimen.height_mm");
  const double diameter =
      required(specimen_.diameter_m, header, "diameter of the specimen", "specimen.diameter_mm");
  as_built_.height_m = height;
  as_built_.volume_m3 = std::numbers::pi / 4 * diameter * diameter * height;
  now_ = stage_start_ = as_built_;
  if (!header.has(Quantity::pore_pressure)) pore_channel_ = Quantity::back_pressure;
  if (options_.membrane != MembraneCorrection::none) {
    required(specimen_.membrane_thickness_m, header, "membrane's thickness",
             "specimen.membrane_thickness_mm");
    required(specimen_.membrane_modulus_pa, header, "membrane's modulus",
             "specimen.membrane_modulus_kPa");
  }
  if (!header.has(Quantity::back_volume))
    warnings_.push_back(
        {0, "no back-volume channel: the volume of the specimen is assumed constant"});
  if (!header.has(Quantity::pore_pressure) && header.has(Quantity::back_pressure))
    warnings_.push_back({0, "no pore-pressure channel: the back pressure is used instead"});
}

void RawReduction::start_stage(const Reading& reading) {
  const auto info = std::ranges::find(stages_, reading.stage, &StageInfo::number);
  stage_ = reading.stage;
  role_ = info == stages_.end() ? StageRole::unknown : info->role;
  const bool shear = role_ == StageRole::shear || role_ == StageRole::unknown;
  if (shear && !sheared_) start_shear(reading);
  if (!sheared_) {
    stage_start_ = now_;
    stage_start_.displacement = or_zero(last_displacement_);
    stage_start_.back_volume = or_zero(last_back_volume_);
  }
}

void RawReduction::start_shear(const Reading& reading) {
  sheared_ = true;
  const double volume = as_built_.volume_m3 - consolidation_outflow_;
  const double isotropic = as_built_.height_m * std::cbrt(volume / as_built_.volume_m3);
  double height = as_built_.height_m - consolidation_shortening_;
  if (specimen_.consolidated_height_m) {
    height = *specimen_.consolidated_height_m;
  } else if (consolidation_shortening_ == 0 && consolidation_outflow_ != 0) {
    height = isotropic;
    warnings_.push_back(
        {reading.line,
         fmt::format("the axial displacement did not change during consolidation: the height at "
                     "the start of shear, {:.3f} mm, is computed from isotropic strain",
                     height * 1e3)});
  } else if (std::fabs(height - isotropic) > 0.01 * as_built_.height_m) {
    warnings_.push_back(
        {reading.line, fmt::format("height at the start of shear: {:.3f} mm from the displacement, "
                                   "{:.3f} mm from isotropic strain; if the ram moved without the "
                                   "specimen, give --set specimen.consolidated_height_mm=...",
                                   height * 1e3, isotropic * 1e3)});
  }
  now_ = {.height_m = height,
          .volume_m3 = volume,
          .displacement = last_displacement_,
          .back_volume = last_back_volume_};
  void_ratio_start_ =
      specimen_.consolidated_void_ratio ? specimen_.consolidated_void_ratio : void_ratio_at(volume);
}

std::optional<double> RawReduction::void_ratio_at(double volume_m3) const {
  if (specimen_.void_ratio)
    return (1 + *specimen_.void_ratio) * volume_m3 / as_built_.volume_m3 - 1;
  if (specimen_.dry_mass_kg && specimen_.specific_gravity)
    return volume_m3 * *specimen_.specific_gravity * kWaterDensity / *specimen_.dry_mass_kg - 1;
  return std::nullopt;
}

State RawReduction::reduce(const Reading& reading) {
  if (reading.has(Quantity::axial_displacement))
    last_displacement_ = reading[Quantity::axial_displacement];
  if (reading.has(Quantity::back_volume)) last_back_volume_ = reading[Quantity::back_volume];
  if (!stage_ || *stage_ != reading.stage) start_stage(reading);
  // Without a value at the start of shear strains count from the first that comes.
  if (std::isnan(now_.displacement)) now_.displacement = last_displacement_;
  if (std::isnan(now_.back_volume)) now_.back_volume = last_back_volume_;

  State s;
  s.reading = reading.number;
  s.time_s = reading.time_s;
  s.stage = reading.stage;
  s.cycle = reading[Quantity::cycle];
  const Reference& from = sheared_ ? now_ : stage_start_;
  // In shear the axis moves from one reading to the next: an old value is none.
  const double shortening =
      (sheared_ ? reading[Quantity::axial_displacement] : last_displacement_) - from.displacement;
  // Water that enters while the specimen is being saturated fills its pores: no change of volume.
  const bool drains = sheared_ || role_ == StageRole::consolidation;
  const double outflow = drains ? or_zero(from.back_volume) - or_zero(last_back_volume_) : 0.0;
  if (!sheared_ && role_ == StageRole::consolidation) {
    consolidation_shortening_ = as_built_.height_m - from.height_m + or_zero(shortening);
    consolidation_outflow_ = as_built_.volume_m3 - from.volume_m3 + outflow;
    now_.height_m = as_built_.height_m - consolidation_shortening_;
    now_.volume_m3 = as_built_.volume_m3 - consolidation_outflow_;
  }
  s.strain.axial = shortening / from.height_m;
  s.volumetric_strain = outflow / from.volume_m3;
  s.strain.radial = (s.volumetric_strain - s.strain.axial) / 2;
  s.area_m2 = from.area() * (1 - s.volumetric_strain) / (1 - s.strain.axial);

  const double cell = reading[Quantity::cell_pressure];
  s.q = reading[Quantity::axial_force] / s.area_m2;
  s.pore_pressure = reading[pore_channel_];
  s.effective_stress = {cell + s.q - s.pore_pressure, cell - s.pore_pressure};
  correct_for_membrane(s);
  s.p_eff = sim::mean_stress(s.effective_stress);
  const auto start = sheared_ ? void_ratio_start_ : void_ratio_at(from.volume_m3);
  if (start) s.void_ratio = *start - s.volumetric_strain * (1 + *start);
  if (sheared_ && !p_eff_start_ && std::isfinite(s.p_eff)) p_eff_start_ = s.p_eff;
  return s;
}

void RawReduction::correct_for_membrane(State& s) const {
  if (options_.membrane == MembraneCorrection::none || !sheared_) return;
  const double stiffness = 4 * *specimen_.membrane_modulus_pa * *specimen_.membrane_thickness_m;
  sim::AxisymmetricStress carried;
  if (options_.membrane == MembraneCorrection::astm) {
    const double diameter = std::sqrt(4 / std::numbers::pi * now_.area());
    carried.axial = stiffness / diameter * s.strain.axial;
  } else {
    const double diameter = *specimen_.diameter_m;  // unstretched: as the membrane was placed
    carried.axial = stiffness / diameter * (s.strain.axial + s.volumetric_strain / 3);
    carried.radial = stiffness / diameter * s.volumetric_strain / 3;
  }
  s.effective_stress.axial -= carried.axial;
  s.effective_stress.radial -= carried.radial;
  s.q = std::isnan(s.pore_pressure) ? s.q - sim::deviator_stress(carried)
                                    : sim::deviator_stress(s.effective_stress);
}

Consolidation RawReduction::consolidation() const {
  Consolidation c;
  if (!sheared_) return c;
  c.p_eff_pa = p_eff_start_;
  c.void_ratio = void_ratio_start_;
  c.height_m = now_.height_m;
  c.diameter_m = std::sqrt(4 / std::numbers::pi * now_.area());
  return c;
}

std::vector<Warning> RawReduction::warnings() const { return warnings_; }

std::optional<double> RawReduction::start_area() const {
  return sheared_ ? std::optional(now_.area()) : std::nullopt;
}

}  // namespace triax::lab
