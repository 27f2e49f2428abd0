// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Identity::evidence of the course of one column or two.
#include "lab/intake/identities.hpp"
#include "lab/intake/series_math.hpp"

namespace triax::lab {

/// Two series grow together, as axial load and axial deformation.
double common_direction_evidence(const Identity& identity, SeriesSpan s,
                                 const SpecimenValues& specimen);
/// The largest magnitude is positive.
double compression_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// The first change has the sign of the factor: a specimen contracts first, also one that dilates
/// later.
double first_contraction_evidence(const Identity& identity, SeriesSpan s,
                                  const SpecimenValues& specimen);
/// The first value is 0.
double start_at_zero_evidence(const Identity& identity, SeriesSpan s,
                              const SpecimenValues& specimen);
/// The first value is above 0.
double start_above_zero_evidence(const Identity& identity, SeriesSpan s,
                                 const SpecimenValues& specimen);
/// Both series have the same first value, as a pore pressure and a back pressure.
double same_start_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// The first series is not below the second one: a total radial stress below the pore pressure is
/// an effective one.
double order_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// Most values are no tension, which soil does not take.
double no_tension_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// The strain reaches that of a test, 1.5 %.
double strain_range_evidence(const Identity& identity, SeriesSpan s,
                             const SpecimenValues& specimen);
/// The same, 0.5 mm.
double displacement_range_evidence(const Identity& identity, SeriesSpan s,
                                   const SpecimenValues& specimen);
/// The same, 50 mm³. A volume that does not change is no evidence.
double volume_range_evidence(const Identity& identity, SeriesSpan s,
                             const SpecimenValues& specimen);
/// The values do not turn back, except a few times.
double one_direction_evidence(const Identity& identity, SeriesSpan s,
                              const SpecimenValues& specimen);
/// Integers that grow or fall in every row.
double row_numbers_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// Integers that grow and repeat.
double counter_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// No change beyond the rounding.
double held_value_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// The lower bound: such quantities are not together in a table.
double mixture_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// The upper bound: such quantities belong together.
double definition_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);

}  // namespace triax::lab
