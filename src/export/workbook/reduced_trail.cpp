// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/reduced_trail.hpp"

#include <algorithm>
#include <utility>

namespace triax::src {
namespace {

Term number_term(double value) { return constant(value); }

/// 1 − (1 − a)(1 − r)²
Term volume_lost(const Term& axial, const Term& radial) {
  const Term one = number_term(1), left = difference(one, radial);
  return difference(one, times(times(difference(one, axial), left), left));
}

/// a/b where that is a number.
Term ratio(const Term& a, const Term& b) { return b.value != 0 ? over(a, b) : Term{}; }

}  // namespace

ReducedTrail::ReducedTrail(const lab::RecordHeader& header, const SpecimenTerms& specimen,
                           ReadingTerms readings)
    : header_(header),
      readings_(std::move(readings)),
      void_ratio_start_(specimen.consolidated_void_ratio.known() ? specimen.consolidated_void_ratio
                                                                 : specimen.void_ratio) {
  using enum lab::Quantity;
  only_excess_ = header.has(excess_pore_pressure) && !header.has(pore_pressure) &&
                 !header.has(axial_stress) && !header.has(radial_stress) &&
                 !header.has(cell_pressure);
}

bool ReducedTrail::undrained(int stage) const {
  const auto info = std::ranges::find(header_.stages, stage, &lab::StageInfo::number);
  return info == header_.stages.end() || info->drainage != lab::Drainage::open;
}

void ReducedTrail::take_stresses(const lab::Reading& reading, StateTerms& keep,
                                 ReducedTerms& s) const {
  using enum lab::Quantity;
  const auto r = [&](lab::Quantity quantity) {
    return readings_.of(quantity, reading, keep.row());
  };
  const Term two = number_term(2), three = number_term(3);
  const Term total_radial = first_known({r(radial_stress), r(cell_pressure)});
  const Term axial =
      first_known({r(effective_axial_stress), difference(r(axial_stress), r(pore_pressure))});
  const Term radial =
      first_known({r(effective_radial_stress), difference(total_radial, r(pore_pressure))});
  s.q_pa =
      keep.keep(StateCell::q_pa, first_known({difference(axial, radial), r(deviator_stress),
                                              difference(r(axial_stress), total_radial),
                                              times(r(stress_ratio), r(mean_effective_stress))}));
  s.p_eff_pa = keep.keep(StateCell::p_eff_pa,
                         first_known({over(sum(axial, times(two, radial)), three),
                                      r(mean_effective_stress), sum(radial, over(s.q_pa, three)),
                                      difference(axial, over(times(two, s.q_pa), three)),
                                      ratio(s.q_pa, r(stress_ratio))}));
  s.axial_pa = keep.keep(StateCell::axial_pa, sum(s.p_eff_pa, over(times(two, s.q_pa), three)));
  s.radial_pa = keep.keep(StateCell::radial_pa, difference(s.p_eff_pa, over(s.q_pa, three)));
  s.pore_pressure_pa =
      keep.keep(StateCell::pore_pressure_pa,
                first_known({r(pore_pressure), difference(total_radial, s.radial_pa),
                             difference(r(axial_stress), s.axial_pa),
                             only_excess_ ? r(excess_pore_pressure) : Term{}}));
}

void ReducedTrail::take_strains(const lab::Reading& reading, StateTerms& keep, ReducedTerms& s) {
  using enum lab::Quantity;
  const auto r = [&](lab::Quantity quantity) {
    return readings_.of(quantity, reading, keep.row());
  };
  const Term one = number_term(1), three = number_term(3);
  if (reading.has(void_ratio) && !first_void_ratio_.known()) first_void_ratio_ = r(void_ratio);
  if (!void_ratio_start_.known()) void_ratio_start_ = first_void_ratio_;
  const Term lost_voids =
      over(difference(first_void_ratio_, r(void_ratio)), sum(one, first_void_ratio_));
  s.axial_strain = keep.keep_in(
      kAxialStrainColumn,
      first_known({r(axial_strain), sum(r(shear_strain), over(r(volumetric_strain), three))}));
  s.volumetric_strain = keep.keep_in(
      kVolumetricStrainColumn,
      first_known({r(volumetric_strain), volume_lost(r(axial_strain), r(radial_strain)),
                   times(three, difference(r(axial_strain), r(shear_strain))), lost_voids,
                   undrained(reading.stage) ? number_term(0) : Term{}}));
  s.void_ratio = r(void_ratio);
  if (!s.void_ratio.known() && void_ratio_start_.known())
    s.void_ratio =
        difference(void_ratio_start_, times(s.volumetric_strain, sum(one, void_ratio_start_)));
  if (reading.has(current_area)) s.area_m2 = keep.keep(StateCell::area_m2, r(current_area));
}

ReducedTerms ReducedTrail::reduce(const lab::Reading& reading, StateTerms& keep) {
  ReducedTerms s;
  take_stresses(reading, keep, s);
  take_strains(reading, keep, s);
  return s;
}

}  // namespace triax::src
