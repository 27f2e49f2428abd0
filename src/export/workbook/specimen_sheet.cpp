// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/specimen_sheet.hpp"

#include <numbers>
#include <optional>

#include "sim/mechanics/units.hpp"
#include "src/export/workbook/layout.hpp"

namespace triax::src {
namespace {

class NumberRows {
 public:
  explicit NumberRows(Sheet& sheet) : sheet_(sheet) {}

  /// A row "label, value in its unit, unit"; the value in SI as what stands there.
  Term add(const char* label, const std::optional<double>& si, const char* unit_name) {
    sheet_.text(row_, 0, label);
    const sim::Unit unit = *sim::find_unit(unit_name);
    Term term;
    if (si) {
      const double field = sim::to_field(*si, unit);
      sheet_.exact(row_, 1, field);
      term = cell(on_sheet(kSpecimenSheet, 1, row_), field);
      if (unit.scale != 1) term = times(term, constant(unit.scale));
    } else {
      sheet_.text(row_, 1, "not given");
    }
    sheet_.text(row_++, 2, unit_name);
    return term;
  }
  /// A row whose value follows from those above.
  Term add(const char* label, const Term& term, const char* unit_name) {
    sheet_.text(row_, 0, label);
    sheet_.formula(row_, 1, term);
    sheet_.text(row_, 2, unit_name);
    return cell(on_sheet(kSpecimenSheet, 1, row_++), term.value);
  }
  std::size_t row() const { return row_; }

 private:
  Sheet& sheet_;
  std::size_t row_ = kFirstRow;
};

}  // namespace

SpecimenTerms write_specimen(Sheet& sheet, const db::StoredTest& test,
                             const std::vector<Fact>& facts) {
  sheet.widths(0, 0, 34);
  sheet.widths(1, 1, 24);
  sheet.text(kHeadingRow, 0, "Specimen", Look::heading);
  sheet.text(kHeadingRow, 1, "Value", Look::heading);
  sheet.text(kHeadingRow, 2, "Unit", Look::heading);
  const lab::SpecimenInfo& s = test.header.specimen;
  NumberRows rows(sheet);
  SpecimenTerms terms;
  terms.height_m = rows.add("height as built", s.height_m, "mm");
  terms.diameter_m = rows.add("diameter as built", s.diameter_m, "mm");
  const Term& d = terms.diameter_m;
  terms.volume_m3 =
      rows.add("volume as built: π/4 D² H",
               times(times(times(over({std::numbers::pi, "PI()", false}, constant(4)), d), d),
                     terms.height_m),
               "m3");
  terms.void_ratio = rows.add("void ratio as built", s.void_ratio, "");
  terms.consolidated_void_ratio =
      rows.add("void ratio at the start of shear, typed in", s.consolidated_void_ratio, "");
  terms.consolidated_height_m =
      rows.add("height at the start of shear, typed in", s.consolidated_height_m, "mm");
  terms.dry_mass_kg = rows.add("dry mass", s.dry_mass_kg, "g");
  terms.specific_gravity = rows.add("specific gravity of the grains", s.specific_gravity, "");
  terms.membrane_thickness_m = rows.add("thickness of the membrane", s.membrane_thickness_m, "mm");
  terms.membrane_modulus_pa = rows.add("modulus of the membrane", s.membrane_modulus_pa, "kPa");
  rows.add("limit friction angle", s.limit_friction_angle_rad, "deg");
  rows.add("cohesion", s.cohesion_pa, "kPa");
  // Results: nothing rests on their last bit.
  const lab::Consolidation& c = test.summary.consolidation;
  rows.add("p′ at the start of shear", c.p_eff_pa, "kPa");
  rows.add("B value", c.b_value, "");
  rows.add("void ratio at the start of shear", c.void_ratio, "");
  rows.add("height at the start of shear", c.height_m, "mm");
  rows.add("diameter at the start of shear", c.diameter_m, "mm");

  std::size_t row = rows.row() + 1;
  for (const Fact& fact : facts) {
    sheet.text(row, 0, fact.label);
    for (const std::string& line : fact.lines) sheet.text(row++, 1, line);
  }
  row += 1;
  for (const lab::Note& note : test.header.notes) {
    sheet.text(row, 0, note.label.empty() ? "from the file" : note.label);
    sheet.text(row++, 1, note.text);
  }
  return terms;
}

}  // namespace triax::src
