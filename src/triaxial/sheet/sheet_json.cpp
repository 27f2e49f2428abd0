// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_json.hpp"

#include <cmath>

#include "src/study/sheet/deviations.hpp"
#include "src/study/sheet/total_stress.hpp"

namespace triax::src {
namespace {

using study::Json;

Json failure_json(const SheetTest& test) {
  const auto& values = test.values;
  const auto at = values.failure.value_or(study::ScanValues{});
  const bool known = values.failure.has_value();
  const bool total = test.result.stored.header.is_total_stress();
  return {{"criterion", to_string(values.options.failure)},
          {"reason", study::json_text(values.failure_reason)},
          {"reading", known ? Json(at.state.reading) : Json(nullptr)},
          {"axial_strain", study::json_number(if_known(at.state.strain.axial))},
          {"q_kPa", study::json_kPa(if_known(at.state.q))},
          {"cell_pressure_kPa", study::json_kPa(if_known(at.cell_pressure))},
          {"pore_pressure_kPa", study::json_kPa(if_known(at.state.pore_pressure))},
          {"p_eff_kPa", study::json_kPa(if_known(at.state.p_eff))},
          {"undrained_strength_kPa",
           study::json_kPa(total ? study::undrained_strength(values.failure) : std::nullopt)}};
}

Json consolidation_json(const SheetTest& test) {
  const auto& values = test.values;
  const auto& diameter = test.result.stored.summary.consolidation.diameter_m;
  std::optional<double> t100, c_v;
  if (values.consolidation && values.consolidation->fit) {
    t100 = values.consolidation->fit->t100_s;
    if (diameter)
      c_v = study::coefficient_of_consolidation(*diameter, values.options.drained_at, *t100);
  }
  return {{"drained_at", study::to_string(values.options.drained_at)},
          {"drained_at_is_said", values.options.boundary_is_said},
          {"t100_s", study::json_number(t100)},
          {"c_v_m2_per_s", study::json_number(c_v)}};
}

Json corrections_json(const SheetTest& test) {
  const auto c = study::load_corrections(test.result.stored, test.values, test.words);
  const auto of = [](const auto& part) {
    return study::json_kPa(part ? std::optional(part->taken_off_pa) : std::nullopt);
  };
  return {{"taken_off", false},  // of all that is said elsewhere
          {"side_drains_kPa", of(c.side_drains)},
          {"side_drains_reason", study::json_text(c.why_no_side_drains)},
          {"piston_kPa", of(c.piston)},
          {"piston_reason", study::json_text(c.why_no_piston)},
          {"q_without_them_kPa", study::json_kPa(c.q_left_pa(test.values))}};
}

}  // namespace

Json sheet_json(const SheetTest& test) {
  return {{"failure", failure_json(test)},
          {"rate_per_s", study::json_number(test.values.rate_per_s)},
          {"allowed_rate_per_s", study::json_number(test.values.allowed_rate_per_s)},
          {"consolidation", consolidation_json(test)},
          {"corrections", corrections_json(test)},
          {"deviations", study::deviations_of(test.result.stored, test.values, test.words)}};
}

}  // namespace triax::src
