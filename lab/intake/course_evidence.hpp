// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Identity::evidence of the course of one column or two.
#include "lab/intake/identities.hpp"

namespace triax::lab {

/// Two series grow together, as axial load and axial deformation.
EvidenceFunction common_direction_evidence;
/// The largest magnitude is positive.
EvidenceFunction compression_evidence;
/// The first change of the volume has the sign of the factor: a specimen contracts first, also one
/// that dilates later. With an axis as second series, changes before it moves do not count, and
/// there is no evidence if the volume changes in both directions before the specimen is sheared.
EvidenceFunction first_contraction_evidence;
/// The first value is 0.
EvidenceFunction start_at_zero_evidence;
/// The first value is above 0.
EvidenceFunction start_above_zero_evidence;
/// Both series have the same first value, as a pore pressure and a back pressure.
EvidenceFunction same_start_evidence;
/// The first series is not below the second one: a total radial stress below the pore pressure is
/// an effective one.
EvidenceFunction order_evidence;
/// Most values are no tension, which soil does not take.
EvidenceFunction no_tension_evidence;
/// The largest strain is that of a test, 1.5 to 100 %.
EvidenceFunction strain_range_evidence;
/// The displacement reaches that of a test, 0.5 mm.
EvidenceFunction displacement_range_evidence;
/// The change of volume reaches that of a test, 50 mm³. A volume that does not change is no
/// evidence.
EvidenceFunction volume_range_evidence;
/// The values do not turn back, except a few times.
EvidenceFunction one_direction_evidence;
/// Integers that grow or fall in every row.
EvidenceFunction row_numbers_evidence;
/// Integers that grow and repeat.
EvidenceFunction counter_evidence;
/// No change beyond the rounding.
EvidenceFunction held_value_evidence;
/// The lower bound: such quantities are not together in a table.
EvidenceFunction mixture_evidence;
/// The upper bound: such quantities belong together.
EvidenceFunction definition_evidence;

}  // namespace triax::lab
