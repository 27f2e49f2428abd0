// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/stage_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "lab/base/bounds.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {
namespace {

constexpr double kKpaPerMin = 1e3 / 60;

const AxialWay& read_way(const TomlTable& table) {
  const std::string word = table.required_text("axial");
  std::vector<std::string> known;
  for (const AxialWay& way : axial_ways()) {
    if (way.word == word) return way;
    known.emplace_back(way.word);
  }
  table.fail("axial", invalid_value(word, known));
}

void read_perturbation(const TomlTable& table, Stage& stage) {
  stage.load_step_n = table.number("load_step_N", {.at_least = -1e5, .at_most = 1e5}).value_or(0);
  stage.impulse_n_s = table.number("impulse_N_s", {.at_least = -1e3, .at_most = 1e3}).value_or(0);
}

void read_axis(const TomlTable& table, const LoadingFrame& frame, Stage& stage) {
  const AxialWay& way = read_way(table);
  stage.axial = way.action;
  if (by_force(stage.axial)) read_perturbation(table, stage);
  if (way.read != nullptr) way.read(table, frame, stage);
}

/// Reads one controller's demand; `pressure_pa` is where it starts, NaN if that is not known.
PressureDemand read_demand(const TomlTable& table, const std::string& name,
                           const PressureController& controller, double pressure_pa) {
  const std::string rate_key = name + "_rate_kPa_per_min", target_key = name + "_target_kPa";
  PressureDemand demand;
  const auto rate = table.number(rate_key);
  const auto target =
      table.number(target_key, {.at_least = 0, .at_most = controller.range_pa / 1e3});
  if (!rate) {
    if (target) table.fail(target_key, fmt::format("needs {} as well", rate_key));
    return demand;
  }
  if (*rate == 0) table.fail(rate_key, "is 0; leave it out to hold the pressure");
  if (std::abs(*rate) * kKpaPerMin > controller.rate_limit_pa_per_s * (1 + 1e-9))
    table.fail(rate_key, fmt::format("the controller gives at most {:g} kPa/min",
                                     controller.rate_limit_pa_per_s / kKpaPerMin));
  demand.rate_pa_per_s = *rate * kKpaPerMin;
  if (target) {
    demand.target_pa = 1e3 * *target;
    if (std::isfinite(pressure_pa) && (*demand.target_pa - pressure_pa) * *rate < 0)
      table.fail(target_key, fmt::format("cannot be reached from {:g} kPa: the sign of {} is wrong",
                                         pressure_pa / 1e3, rate_key));
  }
  return demand;
}

/// Pressure when the stage is over: its target if the stage waits for that, else unknown (NaN).
double pressure_after(const Stage& stage, const PressureDemand& demand, EndQuantity pressure,
                      double start_pa) {
  if (demand.rate_pa_per_s == 0) return start_pa;
  for (const EndCondition& end : stage.end) {
    const auto bound = demand.rate_pa_per_s > 0 ? end.above : end.below;
    if (end.quantity != pressure || !bound || demand.target_pa != bound) return std::nan("");
  }
  return *demand.target_pa;
}

/// Whether a pressure that starts at `start` under this demand can come to the bound.
bool reachable(const EndCondition& end, const PressureDemand& demand, double start_pa,
               const PressureController& controller) {
  if (!std::isfinite(start_pa)) return true;
  double low = start_pa, high = start_pa;
  if (demand.rate_pa_per_s > 0) high = demand.target_pa.value_or(controller.range_pa);
  if (demand.rate_pa_per_s < 0) low = demand.target_pa.value_or(0);
  return end.above ? *end.above <= high : *end.below >= low;
}

void check_strain_path(const TomlTable& table, const Stage& stage) {
  if (!stage.valve_open)
    table.fail("strain_path_R",
               "needs drainage = \"open\", because the back controller prescribes the volume");
  if (stage.back.rate_pa_per_s != 0)
    table.fail("back_rate_kPa_per_min", "the back controller cannot follow strain_path_R as well");
}

EndCondition read_end(const TomlTable& table) {
  const std::string word = table.required_text("quantity");
  const EndQuantityKey* key = nullptr;
  std::vector<std::string> known;
  for (const EndQuantityKey& candidate : end_quantity_keys()) {
    known.emplace_back(candidate.key);
    if (candidate.key == word) key = &candidate;
  }
  if (key == nullptr) table.fail("quantity", invalid_value(word, known));
  EndCondition end;
  end.quantity = key->quantity;
  const Bounds bounds{.at_least = key->lowest, .at_most = key->highest};
  if (const auto above = table.number("above", bounds)) end.above = *above * key->scale;
  if (const auto below = table.number("below", bounds)) end.below = *below * key->scale;
  table.finish();
  if (end.above.has_value() == end.below.has_value())
    table.fail("", "an end condition needs exactly one of above and below");
  if (end.quantity == EndQuantity::time && (end.below || *end.above <= 0))
    table.fail("quantity", "time only increases: use above, greater than 0");
  return end;
}

void check_ends(const TomlTable& table, const Stage& stage, const Programme& programme,
                double cell_pa, double back_pa) {
  for (const EndCondition& end : stage.end) {
    const bool cell = end.quantity == EndQuantity::cell_pressure;
    const bool back = end.quantity == EndQuantity::back_pressure;
    if ((cell && !reachable(end, stage.cell, cell_pa, programme.cell_controller)) ||
        (back && !reachable(end, stage.back, back_pa, programme.back_controller)))
      table.fail("end", fmt::format("the {} pressure never reaches {:g} kPa in this stage",
                                    cell ? "cell" : "back",
                                    end.above.value_or(end.below.value_or(0)) / 1e3));
    if (end.quantity == EndQuantity::time && *end.above > stage.time_limit_s)
      table.fail("end", fmt::format("this time is never reached: time_limit_min is {:g}",
                                    stage.time_limit_s / 60));
    const double direction = stage.axial_rate_m_per_s;
    const double travel = programme.frame.travel_m;
    const double displaced = end.above.value_or(-end.below.value_or(0));
    if (end.quantity == EndQuantity::axial_displacement && displaced > travel)
      table.fail("end", fmt::format("the frame's travel ends at {:g} mm", travel * 1e3));
    if (end.quantity == EndQuantity::axial_strain && stage.end.size() == 1 &&
        ((end.above && *end.above > 0 && direction < 0) ||
         (end.below && *end.below < 0 && direction > 0)))
      table.fail("end", "the axis moves in the other direction");
  }
}

}  // namespace

Logging read_logging(const TomlTable& table, const Logging& otherwise) {
  Logging logging;
  logging.interval_s = table.number("scan_interval_s", {.at_least = 1e-3, .at_most = 3600})
                           .value_or(otherwise.interval_s);
  const auto averaging = table.number("averaging_s", {.at_least = 0, .at_most = 3600});
  logging.averaging_s = averaging.value_or(otherwise.averaging_s);
  if (logging.averaging_s <= logging.interval_s) return logging;
  table.fail(averaging ? "averaging_s" : "scan_interval_s",
             fmt::format("a reading every {:g} s cannot be averaged over {:g} s; write averaging_s "
                         "= {:g} or less{}",
                         logging.interval_s, logging.averaging_s, logging.interval_s,
                         averaging ? "" : " here, too"));
}

Stage read_stage(const TomlTable& table, const Programme& programme, double& cell_pa,
                 double& back_pa) {
  Stage stage;
  stage.line = table.line();
  stage.name = table.required_text("name");
  const std::string role = table.required_text("role");
  const auto known_role = stage_role_from(role);
  if (!known_role || *known_role == StageRole::unknown)
    table.fail("role",
               invalid_value(role, {"saturation", "b_check", "consolidation", "shear", "hold"}));
  stage.role = *known_role;
  const std::string drainage = table.required_text("drainage");
  if (drainage != "open" && drainage != "closed")
    table.fail("drainage",
               fmt::format("{} is not valid; expected open or closed", excerpt(drainage)));
  stage.valve_open = drainage == "open";
  read_axis(table, programme.frame, stage);
  stage.cell = read_demand(table, "cell", programme.cell_controller, cell_pa);
  stage.back = read_demand(table, "back", programme.back_controller, back_pa);
  if (stage.strain_path_R) check_strain_path(table, stage);
  stage.logging = read_logging(table, programme.logging);
  stage.time_limit_s =
      60 * table.number("time_limit_min", {.above = 0, .at_most = 1e5}).value_or(1440);
  const auto ends = table.tables("end");
  if (ends.empty())
    table.fail("",
               fmt::format("the stage {} has no end; write end = [{{quantity = \"q_kPa\", above "
                           "= 30}}]",
                           stage.name));
  for (const TomlTable& end : ends) stage.end.push_back(read_end(end));
  table.finish();
  check_ends(table, stage, programme, cell_pa, back_pa);
  cell_pa = pressure_after(stage, stage.cell, EndQuantity::cell_pressure, cell_pa);
  back_pa = pressure_after(stage, stage.back, EndQuantity::back_pressure, back_pa);
  return stage;
}

}  // namespace triax::lab
