// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Identity::evidence of relations between quantities.
#include "lab/intake/identities.hpp"

namespace triax::lab {

/// The sum of the series by the coefficients of the identity is 0 or constant.
EvidenceFunction sum_evidence;
/// The first series is proportional to the second one.
EvidenceFunction direct_evidence;
/// The first series is proportional to the second one; the factor is the height of the specimen.
EvidenceFunction height_evidence;
/// The factor is the first height of the series.
EvidenceFunction current_height_evidence;
/// Area and axial strain.
EvidenceFunction area_evidence;
/// Force, stress and area.
EvidenceFunction force_over_area_evidence;
/// Force, stress and axial strain; the factor is the initial area.
EvidenceFunction force_over_strain_evidence;
/// The first series is proportional to the second one divided by the third one.
EvidenceFunction quotient_evidence;

}  // namespace triax::lab
