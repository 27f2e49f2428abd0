// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lab/ags/ags_data_type.hpp"
#include "lab/base/text.hpp"
#include "lab/results/test_type.hpp"
#include "src/study/handover/ags_codes.hpp"
#include "src/study/handover/ags_delivery.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

constexpr double kKilopascal = 1e3, kMegapascal = 1e6, kPercent = 1e-2, kMillimetre = 1e-3;
constexpr double kHour = 3600, kMinute = 60;
constexpr double kWater = 1e3, kMegagram = 1e3;  // kg/m³, kg

/// ρ_d = m_d/V, else G_s ρ_w/(1 + e) as built.
std::optional<double> dry_density(const lab::SpecimenInfo& s) {
  if (s.dry_mass_kg && s.height_m && s.diameter_m)
    return *s.dry_mass_kg / (std::numbers::pi / 4 * *s.diameter_m * *s.diameter_m * *s.height_m);
  if (s.specific_gravity && s.void_ratio) return *s.specific_gravity * kWater / (1 + *s.void_ratio);
  return std::nullopt;
}

std::string drainage_word(const lab::RecordHeader& header, const ShearValues& shear) {
  const lab::StageInfo* const stage =
      shear.start ? header.stage(shear.start->state.stage) : nullptr;
  if (stage == nullptr || stage->drainage == lab::Drainage::unknown) return {};
  return stage->drainage == lab::Drainage::open ? "Drained" : "Undrained";
}

void put_start(AgsCells& row, const ShearValues& shear) {
  if (!shear.start) return;
  const auto& [state, cell, back] = *shear.start;
  row["TRET_CONP"] = ags_value("TRET_CONP", state.p_eff, kKilopascal);
  row["TRET_CELL"] = ags_value("TRET_CELL", cell, kKilopascal);
  row["TRET_PWPI"] = ags_value("TRET_PWPI", state.pore_pressure, kKilopascal);
  row["TRET_BACK"] = ags_value("TRET_BACK", back, kKilopascal);
  row["TRET_CVP"] = ags_value("TRET_CVP", state.effective_stress.axial, kKilopascal);
  row["TRET_CRP"] = ags_value("TRET_CRP", state.effective_stress.radial, kKilopascal);
  row["TRET_MEAN"] = ags_value("TRET_MEAN", shear.largest_p_eff, kKilopascal);
}

/// Of a test that holds q there is no failure by the largest q.
void put_failure(AgsCells& row, const ShearValues& shear, bool undrained, bool holds_q) {
  if (!shear.failure || !shear.start || holds_q) return;
  const lab::State& at = shear.failure->state;
  const double strain = at.strain.axial, hours = (at.time_s - shear.start->state.time_s) / kHour;
  const double moved = strain - shear.start->state.strain.axial;
  if (hours > 0) row["TRET_STRR"] = ags_value("TRET_STRR", moved / hours, kPercent);
  row["TRET_STRN"] = ags_value("TRET_STRN", strain, kPercent);
  row["TRET_DEVF"] = ags_value("TRET_DEVF", at.q, kKilopascal);
  row["TRET_PWPF"] = ags_value("TRET_PWPF", at.pore_pressure, kKilopascal);
  if (undrained)
    row["TRET_CU"] = ags_value("TRET_CU", std::abs(at.q) / 2, kKilopascal);
  else
    row["TRET_STV"] = ags_value("TRET_STV", at.volumetric_strain, kPercent);
  row["TRET_EP50"] = ags_value("TRET_EP50", shear.half_strain, kPercent);
  if (shear.half_strain && *shear.half_strain > 0)
    row["TRET_E50"] = ags_value("TRET_E50", at.q / 2 / *shear.half_strain, kMegapascal);
}

std::string failure_criterion(bool holds_q) {
  return holds_q ? "Onset of instability by second-order work" : "Largest deviator stress";
}

}  // namespace

std::string ags_value(const std::string& heading, std::optional<double> si, double unit_si) {
  if (!si) return {};
  const auto* const definition = ags_heading(heading.substr(0, 4), heading);
  return lab::ags_number(*si / unit_si, definition->type);
}

std::string ags_value(const std::string& heading, double si, double unit_si) {
  return ags_value(heading, std::optional(si), unit_si);
}

std::string ags_kind(const db::StoredTest& test) {
  return has_verdict(test) ? std::string(to_string(test.summary.collapse.kind)) : "not assessed";
}

std::optional<double> eta_at_loss_of_control(const db::StoredTest& test) {
  const auto& lost = test.summary.collapse.loss_of_control;
  return lost ? lost->eta() : std::nullopt;
}

std::string ags_remark(const db::StoredTest& test) {
  std::string remark =
      test.header.origin == lab::Origin::simulated ? "SIMULATED, not measured" : "";
  const auto add = [&](const char* what, const std::optional<lab::Instant>& at) {
    if (at && at->axial_strain)
      remark = lab::joined(
          {remark, fmt::format("{} at an axial strain of {:.2f} %", what, *at->axial_strain * 100)},
          "; ");
  };
  add("onset of instability", collapse_onset(test));
  add("loss of control", test.summary.collapse.loss_of_control);
  if (const auto& c = test.summary.collapse; !c.judged_until_reason.empty())
    remark = lab::joined({remark, c.judged_until_reason}, "; ");
  return lab::ags_ascii(remark);
}

void add_triaxial_rows(AgsRows& rows, const AgsTest& test, const AgsCells& keys) {
  const auto& header = test.stored.header;
  const auto& specimen = header.specimen;
  const auto type = ags_test_type(test.stored, test.shear);
  const bool holds_q = type == "CSD" || type == "CSU";
  AgsCells general = keys;
  general["SPEC_DESC"] = lab::ags_ascii(specimen.material);
  general["TREG_TYPE"] = type;
  general["TREG_FCR"] = failure_criterion(holds_q);
  general["TREG_REM"] = ags_remark(test.stored);
  general["TREG_METH"] = fmt::format("Reduced by triax {}", version());
  if (holds_q)
    general["TREG_DEV"] = "Constant shear: q held while p' falls; no test of the standards";
  rows.add("TREG", general);

  AgsCells row = keys;
  row["TRET_TESN"] = "1";
  row["TRET_SDIA"] = ags_value("TRET_SDIA", specimen.diameter_m, kMillimetre);
  row["TRET_LEN"] = ags_value("TRET_LEN", specimen.height_m, kMillimetre);
  row["TRET_DDEN"] = ags_value("TRET_DDEN", dry_density(specimen), kMegagram);
  row["TRET_IVR"] = ags_value("TRET_IVR", specimen.void_ratio);
  row["TRET_BVAL"] = ags_value("TRET_BVAL", test.stored.summary.consolidation.b_value);
  row["TRET_DRN"] = drainage_word(header, test.shear);
  put_start(row, test.shear);
  put_failure(row, test.shear, row["TRET_DRN"] == "Undrained", holds_q);
  const auto onset = collapse_onset(test.stored);
  row["TRET_ETAC"] = ags_value("TRET_ETAC", onset ? onset->eta() : std::nullopt);
  row["TRET_ETAL"] = ags_value("TRET_ETAL", eta_at_loss_of_control(test.stored));
  row["TRET_KIND"] = ags_kind(test.stored);
  rows.add("TRET", row);
}

void add_total_stress_rows(AgsRows& rows, const AgsTest& test, const AgsCells& keys) {
  const auto& specimen = test.stored.header.specimen;
  AgsCells general = keys;
  general["SPEC_DESC"] = lab::ags_ascii(specimen.material);
  const auto* type = lab::find_test_type(test.stored.header.programme);
  general["TRIG_TYPE"] = type && type->unconfined    ? "UNC"
                         : type && type->multi_stage ? "UUM"
                                                     : "UU";
  if (test.stored.header.origin == lab::Origin::simulated)
    general["TRIG_REM"] = "SIMULATED, not measured";
  general["TRIG_METH"] = fmt::format("Reduced by triax {}", version());
  rows.add("TRIG", general);

  AgsCells row = keys;
  row["TRIT_TESN"] = "1";
  row["TRIT_SDIA"] = ags_value("TRIT_SDIA", specimen.diameter_m, kMillimetre);
  row["TRIT_SLEN"] = ags_value("TRIT_SLEN", specimen.height_m, kMillimetre);
  row["TRIT_DDEN"] = ags_value("TRIT_DDEN", dry_density(specimen), kMegagram);
  if (const auto& shear = test.shear; shear.start && shear.failure) {
    const lab::State& at = shear.failure->state;
    row["TRIT_CELL"] = ags_value("TRIT_CELL", shear.start->cell_pressure, kKilopascal);
    row["TRIT_DEVF"] = ags_value("TRIT_DEVF", at.q, kKilopascal);
    row["TRIT_STRN"] = ags_value("TRIT_STRN", at.strain.axial, kPercent);
    row["TRIT_CU"] = ags_value("TRIT_CU", std::abs(at.q) / 2, kKilopascal);
    const double minutes = (at.time_s - shear.start->state.time_s) / kMinute;
    if (minutes > 0)
      row["TRIT_RATE"] = ags_value(
          "TRIT_RATE", (at.strain.axial - shear.start->state.strain.axial) / minutes, kPercent);
  }
  rows.add("TRIT", row);
}

}  // namespace triax::study
