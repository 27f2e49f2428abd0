// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/ags/ags_data_type.hpp"
#include "src/study/handover/ags_codes.hpp"
#include "src/study/handover/ags_delivery.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

constexpr double kCyclicKilopascal = 1e3, kCyclicPercent = 1e-2, kCyclicMillimetre = 1e-3;

std::string pressure(const char* heading, double pa) {
  return ags_value(heading, pa, kCyclicKilopascal);
}
std::string percent(const char* heading, double plain) {
  return ags_value(heading, plain, kCyclicPercent);
}

AgsCells general_cells(const AgsTest& test, const std::string& type) {
  const auto& specimen = test.stored.header.specimen;
  AgsCells row;
  row["SPEC_DESC"] = lab::ags_ascii(specimen.material);
  row["CTRG_TYPE"] = type.starts_with("CS") ? "" : type;
  row["CTRG_SDIA"] = ags_value("CTRG_SDIA", specimen.diameter_m, kCyclicMillimetre);
  row["CTRG_HIGT"] = ags_value("CTRG_HIGT", specimen.height_m, kCyclicMillimetre);
  row["CTRG_IVR"] = ags_value("CTRG_IVR", specimen.void_ratio);
  row["CTRG_REM"] = ags_remark(test.stored);
  row["CTRG_METH"] = fmt::format("Reduced by triax {}", version());
  const auto onset = collapse_onset(test.stored);
  row["CTRG_ETAC"] = ags_value("CTRG_ETAC", onset ? onset->eta() : std::nullopt);
  row["CTRG_ETAL"] = ags_value("CTRG_ETAL", eta_at_loss_of_control(test.stored));
  row["CTRG_KIND"] = ags_kind(test.stored);
  return row;
}

AgsCells consolidation_cells(const AgsTest& test, const std::string& type) {
  const auto& [state, cell, back] = *test.shear.start;
  AgsCells row;
  row["CTRC_CELL"] = pressure("CTRC_CELL", cell);
  row["CTRC_BPWP"] = pressure("CTRC_BPWP", state.pore_pressure);
  row["CTRC_TYPE"] = type.size() == 4 && type[1] == 'I' ? "ISOTROPIC" : "";
  row["CTRC_BACF"] = pressure("CTRC_BACF", back);
  row["CTRC_INCE"] = ags_value("CTRC_INCE", void_ratio(test.stored));
  row["CTRC_ASE"] = pressure("CTRC_ASE", state.effective_stress.axial);
  row["CTRC_RSE"] = pressure("CTRC_RSE", state.effective_stress.radial);
  row["CTRC_DEVE"] = pressure("CTRC_DEVE", state.q);
  row["CTRC_MNSE"] = pressure("CTRC_MNSE", state.p_eff);
  if (const auto b = test.stored.summary.consolidation.b_value)
    row["CTRC_B"] = percent("CTRC_B", *b);
  return row;
}

/// The first cycle in which the specimen liquefied or moved by 5 %.
std::optional<int> failure_cycle(const lab::CyclicLoading& loading) {
  std::optional<int> cycle;
  for (const auto& at : {loading.liquefied, loading.double_amplitude})
    if (at && (!cycle || at->cycle < *cycle)) cycle = at->cycle;
  return cycle;
}

AgsCells derived_cells(const CycleValues& c, double u_start) {
  AgsCells row;
  row["CTRP_PWPM"] = pressure("CTRP_PWPM", c.u_high - u_start);
  row["CTRP_MNPP"] = pressure("CTRP_MNPP", c.u_low - u_start);
  row["CTRP_MXSS"] = pressure("CTRP_MXSS", c.q_high / 2);
  row["CTRP_MNSS"] = pressure("CTRP_MNSS", c.q_low / 2);
  row["CTRP_AVSS"] = pressure("CTRP_AVSS", (c.q_high + c.q_low) / 4);
  row["CTRP_CSS"] = pressure("CTRP_CSS", (c.q_high - c.q_low) / 4);
  row["CTRP_QMAX"] = pressure("CTRP_QMAX", c.q_high);
  row["CTRP_QMIN"] = pressure("CTRP_QMIN", c.q_low);
  row["CTRP_MNES"] = pressure("CTRP_MNES", c.last.state.p_eff);
  row["CTRP_EAMX"] = percent("CTRP_EAMX", c.strain_high);
  row["CTRP_EAMN"] = percent("CTRP_EAMN", c.strain_low);
  row["CTRP_QEMX"] = pressure("CTRP_QEMX", c.q_at_strain_high);
  row["CTRP_QEMN"] = pressure("CTRP_QEMN", c.q_at_strain_low);
  return row;
}

AgsCells reading_cells(const CycleValues& c, const ShearValues& shear, const std::string& type) {
  const lab::State& s = c.last.state;
  AgsCells row;
  row["CTRD_COND"] = type.size() != 4 ? "" : type[2] == 'U' ? "UNDRAINED" : "DRAINED";
  row["CTRD_CELL"] = pressure("CTRD_CELL", c.last.cell_pressure);
  row["CTRD_BPWP"] = pressure("CTRD_BPWP", s.pore_pressure);
  row["CTRD_EAS"] = percent("CTRD_EAS", s.strain.axial);
  row["CTRD_VOL"] = percent("CTRD_VOL", s.volumetric_strain);
  row["CTRD_DEV"] = pressure("CTRD_DEV", s.q);
  row["CTRD_MEES"] = pressure("CTRD_MEES", s.p_eff);
  row["CTRD_CSTS"] = pressure("CTRD_CSTS", (c.q_high - c.q_low) / 2);
  row["CTRD_DAVS"] = percent("CTRD_DAVS", c.strain_high - c.strain_low);
  row["CTRD_EBPR"] = percent("CTRD_EBPR", (s.pore_pressure - shear.start->state.pore_pressure) /
                                              shear.start->state.effective_stress.radial);
  row["CTRD_REM"] = "Last reading of the cycle";
  return row;
}

AgsCells joined_cells(AgsCells keys, const AgsCells& more) {
  keys.insert(more.begin(), more.end());
  return keys;
}

}  // namespace

void add_cyclic_rows(AgsRows& rows, const AgsTest& test, const AgsCells& keys) {
  const auto type = ags_test_type(test.stored, test.shear);
  rows.add("CTRG", joined_cells(keys, general_cells(test, type)));
  if (!test.shear.start) return;
  AgsCells below = keys;
  below["CTRC_TESN"] = "1";
  rows.add("CTRC", joined_cells(below, consolidation_cells(test, type)));
  const auto failed = failure_cycle(*test.stored.summary.cyclic);
  for (const CycleValues& cycle : test.shear.cycles) {
    below["CTRP_CYC"] = std::to_string(cycle.cycle);
    AgsCells derived = derived_cells(cycle, test.shear.start->state.pore_pressure);
    if (failed && *failed == cycle.cycle) derived["CTRP_CYCF"] = std::to_string(*failed);
    rows.add("CTRP", joined_cells(below, derived));
    rows.add("CTRD", joined_cells(below, reading_cells(cycle, test.shear, type)));
  }
}

}  // namespace triax::study
