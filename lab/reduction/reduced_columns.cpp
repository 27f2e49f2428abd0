#include "lab/reduction/reduced_columns.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

/// The first of the values that is known.
double first_known(std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isnan(value)) return value;
  return kMissing;
}

}  // namespace

ReducedColumns::ReducedColumns(const RecordHeader& header) : stages_(header.stages) {
  void_ratio_start_ = header.specimen.consolidated_void_ratio
                          ? header.specimen.consolidated_void_ratio
                          : header.specimen.void_ratio;
  if (!header.is_raw())
    warnings_.push_back({0,
                         "the record holds reduced stresses and strains, no raw channels: its own "
                         "reduction is taken "
                         "as it is"});
}

bool ReducedColumns::undrained(int stage) const {
  const auto info = std::ranges::find(stages_, stage, &StageInfo::number);
  return info != stages_.end() && info->drainage == Drainage::closed;
}

State ReducedColumns::reduce(const Reading& r) {
  using enum Quantity;
  State s;
  s.reading = r.number;
  s.time_s = r.time_s;
  s.stage = r.stage;
  s.pore_pressure = first_known(
      {r[pore_pressure], r[radial_stress] - r[effective_radial_stress], r[excess_pore_pressure]});
  const double axial = first_known({r[effective_axial_stress], r[axial_stress] - r[pore_pressure]});
  const double radial =
      first_known({r[effective_radial_stress], r[radial_stress] - r[pore_pressure],
                   r[cell_pressure] - r[pore_pressure]});
  s.q = first_known({axial - radial, r[deviator_stress], r[axial_stress] - r[radial_stress],
                     r[stress_ratio] * r[mean_effective_stress]});
  s.p_eff = first_known({(axial + 2 * radial) / 3, r[mean_effective_stress], radial + s.q / 3});
  s.effective_stress = {s.p_eff + 2 * s.q / 3, s.p_eff - s.q / 3};

  s.strain.axial = first_known({r[axial_strain], r[shear_strain] + r[volumetric_strain] / 3});
  s.volumetric_strain = first_known({r[volumetric_strain], r[axial_strain] + 2 * r[radial_strain],
                                     undrained(r.stage) ? 0.0 : kMissing});
  s.strain.radial = (s.volumetric_strain - s.strain.axial) / 2;
  s.void_ratio = r[void_ratio];
  if (std::isnan(s.void_ratio) && void_ratio_start_)
    s.void_ratio = *void_ratio_start_ - s.volumetric_strain * (1 + *void_ratio_start_);
  if (r.has(void_ratio) && !void_ratio_start_) void_ratio_start_ = r[void_ratio];
  if (r.has(current_area)) s.area_m2 = r[current_area];
  if (!p_eff_start_ && std::isfinite(s.p_eff)) p_eff_start_ = s.p_eff;
  return s;
}

Consolidation ReducedColumns::consolidation() const {
  return {.p_eff_pa = p_eff_start_,
          .b_value = {},
          .void_ratio = void_ratio_start_,
          .height_m = {},
          .diameter_m = {}};
}

}  // namespace triax::lab
