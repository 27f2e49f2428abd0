// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/result_rows.hpp"

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

/// The cells of the reader's row by the endings of their headings.
class GroupCells {
 public:
  GroupCells(const AgsReader& reader, AgsNumbers& numbers)
      : reader_(reader), numbers_(numbers), group_(reader.group().name + "_") {}

  std::string text(const char* ending) const { return std::string(reader_.cell(group_ + ending)); }
  std::optional<double> pressure(const char* ending) { return si(ending, "kPa"); }
  std::optional<double> percent(const char* ending) { return si(ending, "%"); }
  std::optional<double> si(const char* ending, const char* unit) {
    return numbers_.si(group_ + ending, unit);
  }

 private:
  const AgsReader& reader_;
  AgsNumbers& numbers_;
  std::string group_;
};

ReferenceResult row_of_specimen(const AgsReader& reader, AgsNumbers& numbers) {
  const auto text = [&](const char* heading) { return std::string(reader.cell(heading)); };
  ReferenceResult row;
  row.group = reader.group().name;
  row.line = reader.line();
  row.specimen = {.location = text("LOCA_ID"),
                  .sample_reference = text("SAMP_REF"),
                  .sample_type = text("SAMP_TYPE"),
                  .sample_id = text("SAMP_ID"),
                  .specimen_reference = text("SPEC_REF"),
                  .sample_top_m = numbers.si("SAMP_TOP", "m"),
                  .specimen_depth_m = numbers.si("SPEC_DPTH", "m")};
  return row;
}

void take_known(std::optional<double>& value, const std::optional<double>& other) {
  if (!value) value = other;
}

}  // namespace

ReferenceResult general_row(const AgsReader& reader, AgsNumbers& numbers) {
  ReferenceResult row = row_of_specimen(reader, numbers);
  GroupCells cells(reader, numbers);
  row.test_type = cells.text("TYPE");
  row.condition = cells.text("COND");
  row.cohesion_pa = cells.pressure("COH");
  row.friction_angle_rad = cells.si("PHI", "deg");
  row.undrained_strength_pa = cells.pressure("CU");  // not in the dictionary, but delivered
  row.failure_criterion = cells.text("FCR");
  row.remarks = cells.text("REM");
  return row;
}

ReferenceResult result_row(const AgsReader& reader, AgsNumbers& numbers) {
  ReferenceResult row = row_of_specimen(reader, numbers);
  GroupCells cells(reader, numbers);
  row.stage = cells.text("TESN");
  row.diameter_m = cells.si("SDIA", "mm");
  row.height_m = cells.si(row.group == "TRIT" ? "SLEN" : "LEN", "mm");
  row.initial_water_content = cells.percent("IMC");
  row.final_water_content = cells.percent("FMC");
  row.bulk_density_kg_m3 = cells.si("BDEN", "Mg/m3");
  row.dry_density_kg_m3 = cells.si("DDEN", "Mg/m3");
  row.b_value = cells.si("BVAL", "");
  row.back_pressure_pa = cells.pressure("BACK");
  row.consolidation_pressure_pa = cells.pressure("CONP");
  row.cell_pressure_pa = cells.pressure("CELL");
  row.initial_pore_pressure_pa = cells.pressure("PWPI");
  row.q_pa = cells.pressure("DEVF");
  row.pore_pressure_pa = cells.pressure("PWPF");
  row.axial_strain = cells.percent("STRN");
  row.volumetric_strain = cells.percent("STV");
  row.undrained_strength_pa = cells.pressure("CU");
  row.failure_mode = cells.text("MODE");
  row.remarks = cells.text("REM");
  return row;
}

void add_general(ReferenceResult& result, const ReferenceResult& general) {
  result.test_type = general.test_type;
  result.condition = general.condition;
  take_known(result.cohesion_pa, general.cohesion_pa);
  take_known(result.friction_angle_rad, general.friction_angle_rad);
  take_known(result.undrained_strength_pa, general.undrained_strength_pa);
  result.failure_criterion = general.failure_criterion;
  result.remarks = joined({general.remarks, result.remarks}, "; ");
}

}  // namespace triax::lab
