// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/raw_trail.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace triax::src {
namespace {

using lab::Quantity;

const Term kNought = constant(0);
const Term kOne = constant(1);

Term or_nought(const Term& term) { return term.known() ? term : kNought; }
Term less(const Term& a, const Term& b) { return b.text == "0" ? a : difference(a, b); }

}  // namespace

RawTrail::RawTrail(const lab::RecordHeader& header, std::string membrane, SpecimenTerms specimen,
                   std::size_t first_reference_row, std::size_t state_columns,
                   ReadingTerms readings)
    : header_(header),
      membrane_(std::move(membrane)),
      specimen_(std::move(specimen)),
      first_row_(first_reference_row),
      state_columns_(state_columns),
      readings_(std::move(readings)),
      height_now_(specimen_.height_m),
      volume_now_(specimen_.volume_m3),
      shortening_(kNought),
      outflow_(kNought) {}

Term RawTrail::void_ratio_at(const Term& volume) const {
  if (specimen_.void_ratio.known())
    return difference(over(times(sum(kOne, specimen_.void_ratio), volume), specimen_.volume_m3),
                      kOne);
  if (specimen_.dry_mass_kg.known() && specimen_.specific_gravity.known())
    return difference(over(times(times(volume, specimen_.specific_gravity), constant(1000)),
                           specimen_.dry_mass_kg),
                      kOne);
  return {};
}

/// 4 E t/D: with the diameter at the start of shear (ASTM), or as built (ISO).
Term RawTrail::membrane_stiffness(const Term& area) const {
  if (membrane_ != "astm" && membrane_ != "iso") return {};
  const Term stiffness =
      times(times(constant(4), specimen_.membrane_modulus_pa), specimen_.membrane_thickness_m);
  if (membrane_ == "iso") return over(stiffness, specimen_.diameter_m);
  const Term four_over_pi = over(constant(4), {std::numbers::pi, "PI()", false});
  return over(stiffness,
              function("SQRT", times(four_over_pi, area), [](double x) { return std::sqrt(x); }));
}

ReferenceRow RawTrail::start_of_stage() const {
  ReferenceRow row;
  row.height_m = height_now_;
  row.volume_m3 = volume_now_;
  row.void_ratio = void_ratio_at(volume_now_);
  row.how = consolidated_ ? "as consolidated so far" : "as built";
  return row;
}

ReferenceRow RawTrail::start_of_shear() const {
  ReferenceRow row;
  row.volume_m3 = less(specimen_.volume_m3, outflow_);
  row.height_m = less(specimen_.height_m, shortening_);
  row.how = "as built less what the transducer measured in consolidation";
  if (specimen_.consolidated_height_m.known()) {
    row.height_m = specimen_.consolidated_height_m;
    row.how = "typed in";
  } else if (shortening_.value == 0 && outflow_.value != 0) {
    const double share = row.volume_m3.value / specimen_.volume_m3.value;
    row.height_m = {specimen_.height_m.value * std::cbrt(share), "", false};
    row.how = "no displacement: isotropic strain, H (V/V as built)^(1/3)";
  }
  row.void_ratio = specimen_.consolidated_void_ratio.known() ? specimen_.consolidated_void_ratio
                                                             : void_ratio_at(row.volume_m3);
  return row;
}

void RawTrail::start_stage(const lab::Reading& reading) {
  const auto info = std::ranges::find(header_.stages, reading.stage, &lab::StageInfo::number);
  stage_ = reading.stage;
  role_ = info == header_.stages.end() ? lab::StageRole::unknown : info->role;
  if (sheared_) return;
  sheared_ = role_ == lab::StageRole::shear || role_ == lab::StageRole::unknown;
  ReferenceRow row = sheared_ ? start_of_shear() : start_of_stage();
  row.from_reading = reading.number;
  row.stage = reading.stage;
  row.displacement_m = or_nought(last_displacement_);
  row.back_volume_m3 = or_nought(last_back_volume_);
  const std::size_t at = first_row_ + references_.size();
  const auto on_stages = [&](ReferenceCell place, const Term& term) {
    return cell(on_sheet(kStagesSheet, static_cast<std::size_t>(place), at), term.value);
  };
  from_.height_m = on_stages(ReferenceCell::height_m, row.height_m);
  from_.volume_m3 = on_stages(ReferenceCell::volume_m3, row.volume_m3);
  from_.area_m2 = on_stages(ReferenceCell::area_m2, over(row.volume_m3, row.height_m));
  if (sheared_) row.membrane_pa = membrane_stiffness(from_.area_m2);
  from_.displacement_m = on_stages(ReferenceCell::displacement_m, row.displacement_m);
  from_.back_volume_m3 = on_stages(ReferenceCell::back_volume_m3, row.back_volume_m3);
  from_.void_ratio = on_stages(ReferenceCell::void_ratio, row.void_ratio);
  from_.membrane_pa = on_stages(ReferenceCell::membrane_pa, row.membrane_pa);
  references_.push_back(std::move(row));
}

ReducedTerms RawTrail::reduce(const lab::Reading& reading, StateTerms& keep) {
  const std::size_t row = keep.row();
  const auto channel = [&](Quantity quantity) { return readings_.of(quantity, reading, row); };
  if (reading.has(Quantity::axial_displacement))
    last_displacement_ = channel(Quantity::axial_displacement);
  if (reading.has(Quantity::back_volume)) last_back_volume_ = channel(Quantity::back_volume);
  if (!stage_ || *stage_ != reading.stage) start_stage(reading);

  ReducedTerms s;
  const Term shortening =
      keep.keep(StateCell::shortening_m, difference(last_displacement_, from_.displacement_m));
  const bool drains = sheared_ || role_ == lab::StageRole::consolidation;
  const Term outflow =
      keep.keep(StateCell::outflow_m3,
                drains ? difference(from_.back_volume_m3, or_nought(last_back_volume_)) : kNought);
  if (!sheared_ && role_ == lab::StageRole::consolidation) {
    const auto on_states = [&](StateCell place, const Term& term) {
      return cell(on_sheet(kStatesSheet, state_columns_ + static_cast<std::size_t>(place), row),
                  term.value);
    };
    shortening_ =
        sum(difference(specimen_.height_m, from_.height_m),
            shortening.known() ? on_states(StateCell::shortening_m, shortening) : kNought);
    outflow_ = sum(difference(specimen_.volume_m3, from_.volume_m3),
                   on_states(StateCell::outflow_m3, outflow));
    height_now_ = difference(specimen_.height_m, shortening_);
    volume_now_ = difference(specimen_.volume_m3, outflow_);
    consolidated_ = true;
  }
  s.axial_strain = keep.keep_in(kAxialStrainColumn, over(shortening, from_.height_m));
  s.volumetric_strain = keep.keep_in(kVolumetricStrainColumn, over(outflow, from_.volume_m3));
  s.area_m2 = keep.keep(StateCell::area_m2,
                        over(times(from_.area_m2, difference(kOne, s.volumetric_strain)),
                             difference(kOne, s.axial_strain)));
  const Term cell_pressure = channel(Quantity::cell_pressure);
  const bool own_pore = header_.has(Quantity::pore_pressure);
  s.q_pa = keep.keep(StateCell::q_measured_pa, over(channel(Quantity::axial_force), s.area_m2));
  s.pore_pressure_pa =
      keep.keep(StateCell::pore_pressure_pa,
                channel(own_pore ? Quantity::pore_pressure : Quantity::back_pressure));
  s.axial_pa = difference(sum(cell_pressure, s.q_pa), s.pore_pressure_pa);
  s.radial_pa = difference(cell_pressure, s.pore_pressure_pa);
  correct_for_membrane(s, keep);
  s.axial_pa = keep.keep(StateCell::axial_pa, s.axial_pa);
  s.radial_pa = keep.keep(StateCell::radial_pa, s.radial_pa);
  const bool corrected = sheared_ && from_.membrane_pa.known();
  s.q_pa = keep.keep(StateCell::q_pa, corrected ? difference(s.axial_pa, s.radial_pa) : s.q_pa);
  s.p_eff_pa = keep.keep(StateCell::p_eff_pa,
                         over(sum(s.axial_pa, times(constant(2), s.radial_pa)), constant(3)));
  if (from_.void_ratio.known())
    s.void_ratio =
        difference(from_.void_ratio, times(s.volumetric_strain, sum(kOne, from_.void_ratio)));
  return s;
}

void RawTrail::correct_for_membrane(ReducedTerms& s, StateTerms& keep) const {
  if (!sheared_ || !from_.membrane_pa.known()) return;
  const Term third = over(s.volumetric_strain, constant(3));
  const bool iso = membrane_ == "iso";
  const Term axial =
      keep.keep(StateCell::membrane_axial_pa,
                times(from_.membrane_pa, iso ? sum(s.axial_strain, third) : s.axial_strain));
  s.axial_pa = difference(s.axial_pa, axial);
  if (!iso) return;
  const Term radial = keep.keep(StateCell::membrane_radial_pa,
                                over(times(from_.membrane_pa, s.volumetric_strain), constant(3)));
  s.radial_pa = difference(s.radial_pa, radial);
}

}  // namespace triax::src
