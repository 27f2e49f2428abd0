// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Identity::evidence of relations between quantities.
#include "lab/intake/identities.hpp"
#include "lab/intake/series_math.hpp"

namespace triax::lab {

/// The sum of the series by the coefficients of the identity is 0 or constant.
double sum_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// The first series is proportional to a function of the others: to the second one.
double direct_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// The same; the factor is the height of the specimen.
double height_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// Area and axial strain.
double area_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);
/// Force, stress and area.
double force_over_area_evidence(const Identity& identity, SeriesSpan s,
                                const SpecimenValues& specimen);
/// Force, stress and axial strain; the factor is the initial area.
double force_over_strain_evidence(const Identity& identity, SeriesSpan s,
                                  const SpecimenValues& specimen);
/// To the second one divided by the third one.
double quotient_evidence(const Identity& identity, SeriesSpan s, const SpecimenValues& specimen);

}  // namespace triax::lab
