// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is known of the specimen and of the test, as a sheet whose cells formulas refer to.
#include "db/store.hpp"
#include "src/export/workbook/book.hpp"
#include "src/output/fact.hpp"

namespace triax::src {

/// Dimensions of the specimen, SI, as what stands on its sheet; unknown where nobody says.
struct SpecimenTerms {
  Term height_m, diameter_m, volume_m3;
  Term void_ratio, consolidated_void_ratio, consolidated_height_m;
  Term dry_mass_kg, specific_gravity, membrane_thickness_m, membrane_modulus_pa;
};

/// Writes the sheet from row kHeadingRow on; `facts` are told below the numbers.
SpecimenTerms write_specimen(Sheet& sheet, const db::StoredTest& test,
                             const std::vector<Fact>& facts);

}  // namespace triax::src
