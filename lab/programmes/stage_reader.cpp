#include "lab/programmes/stage_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/programmes/strict_table.hpp"
#include "lab/records/bad_input.hpp"

namespace triax::lab {
namespace {

constexpr Bounds kPositive{.above = 0};
constexpr double kKpaPerMin = 1e3 / 60;

constexpr std::pair<std::string_view, AxialAction> kActions[] = {
    {"free", AxialAction::free},
    {"displacement", AxialAction::displacement},
    {"load", AxialAction::load},
    {"constant_q", AxialAction::constant_q}};

template <class Pairs>
[[noreturn]] void unknown_word(const StrictTable& table, std::string_view key,
                               const std::string& found, const Pairs& pairs) {
  std::vector<std::string> known;
  for (const auto& pair : pairs) known.emplace_back(pair.first);
  table.fail(key, fmt::format("is \"{}\", must be one of {}", found, fmt::join(known, ", ")));
}

AxialAction read_action(StrictTable& table) {
  const std::string word = table.text("axial");
  for (const auto& [name, action] : kActions)
    if (name == word) return action;
  unknown_word(table, "axial", word, kActions);
}

double nonzero(StrictTable& table, std::string_view key) {
  const double value = table.number(key, {});
  if (value == 0) table.fail(key, "is 0; leave the stage's axis free or give a rate");
  return value;
}

void read_axis(StrictTable& table, const LoadingFrame& frame, Stage& stage) {
  stage.axial = read_action(table);
  if (stage.axial == AxialAction::displacement) {
    stage.axial_rate_m_per_s = nonzero(table, "axial_rate_mm_per_min") * 1e-3 / 60;
    if (!gives(frame, stage.axial_rate_m_per_s))
      table.fail("axial_rate_mm_per_min",
                 fmt::format("the frame gives {:g} to {:g} mm/min", frame.slowest_m_per_s * 6e4,
                             frame.fastest_m_per_s * 6e4));
  } else if (stage.axial == AxialAction::load) {
    stage.load_rate_n_per_s = nonzero(table, "load_rate_N_per_min") / 60;
  } else if (stage.axial == AxialAction::constant_q) {
    if (const auto q = table.maybe_number("held_q_kPa", {})) stage.held_q_pa = 1e3 * *q;
  }
}

/// Reads one controller's demand; `pressure_pa` is where it starts, NaN if that is not known.
PressureDemand read_demand(StrictTable& table, const std::string& name,
                           const PressureController& controller, double pressure_pa) {
  const std::string rate_key = name + "_rate_kPa_per_min", target_key = name + "_target_kPa";
  PressureDemand demand;
  const auto rate = table.maybe_number(rate_key, {});
  const auto target =
      table.maybe_number(target_key, {.at_least = 0, .at_most = controller.range_pa / 1e3});
  if (!rate) {
    if (target) table.fail(target_key, fmt::format("needs {} beside it", rate_key));
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
      table.fail(target_key,
                 fmt::format("lies behind the start at {:g} kPa: the sign of {} is wrong",
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

EndCondition read_end(StrictTable table) {
  const std::string word = table.text("quantity");
  const EndQuantityKey* key = nullptr;
  std::vector<std::string> known;
  for (const EndQuantityKey& candidate : end_quantity_keys()) {
    known.emplace_back(candidate.key);
    if (candidate.key == word) key = &candidate;
  }
  if (key == nullptr) {
    const std::string near = nearest_word(word, known);
    table.fail("quantity",
               fmt::format("is \"{}\", {}", word,
                           near.empty() ? fmt::format("must be one of {}", fmt::join(known, ", "))
                                        : fmt::format("did you mean {}?", near)));
  }
  EndCondition end;
  end.quantity = key->quantity;
  const Bounds bounds{.at_least = key->lowest, .at_most = key->highest};
  if (const auto above = table.maybe_number("above", bounds)) end.above = *above * key->scale;
  if (const auto below = table.maybe_number("below", bounds)) end.below = *below * key->scale;
  table.done();
  if (end.above.has_value() == end.below.has_value())
    table.fail("", "an end condition needs exactly one of above and below");
  if (end.quantity == EndQuantity::time && (end.below || *end.above <= 0))
    table.fail("quantity", "time only grows: write above, greater than 0");
  return end;
}

void check_ends(StrictTable& table, const Stage& stage, const Programme& programme, double cell_pa,
                double back_pa) {
  for (const EndCondition& end : stage.end) {
    const bool cell = end.quantity == EndQuantity::cell_pressure;
    const bool back = end.quantity == EndQuantity::back_pressure;
    if ((cell && !reachable(end, stage.cell, cell_pa, programme.cell_controller)) ||
        (back && !reachable(end, stage.back, back_pa, programme.back_controller)))
      table.fail("end", fmt::format("the {} pressure never comes to {:g} kPa in this stage",
                                    cell ? "cell" : "back",
                                    end.above.value_or(end.below.value_or(0)) / 1e3));
    if (end.quantity == EndQuantity::time && *end.above > stage.time_limit_s)
      table.fail("end", fmt::format("the time never comes: time_limit_min is {:g}",
                                    stage.time_limit_s / 60));
    const double direction = stage.axial_rate_m_per_s;
    const double travel = programme.frame.travel_m;
    if (end.quantity == EndQuantity::axial_displacement && end.above && *end.above > travel)
      table.fail("end", fmt::format("the frame's travel ends at {:g} mm", travel * 1e3));
    if (end.quantity == EndQuantity::axial_strain && stage.end.size() == 1 &&
        ((end.above && *end.above > 0 && direction < 0) ||
         (end.below && *end.below < 0 && direction > 0)))
      table.fail("end", "the axis moves away from this strain");
  }
}

}  // namespace

Stage read_stage(StrictTable& table, const Programme& programme, double& cell_pa, double& back_pa) {
  Stage stage;
  stage.line = table.line();
  stage.name = table.text("name");
  const std::string role = table.text("role");
  const auto known_role = stage_role_from(role);
  if (!known_role || *known_role == StageRole::unknown)
    table.fail(
        "role",
        fmt::format("is \"{}\", must be one of saturation, b_check, consolidation, shear", role));
  stage.role = *known_role;
  const std::string drainage = table.text("drainage");
  if (drainage != "open" && drainage != "closed")
    table.fail("drainage", fmt::format("is \"{}\", must be open or closed", drainage));
  stage.valve_open = drainage == "open";
  read_axis(table, programme.frame, stage);
  stage.cell = read_demand(table, "cell", programme.cell_controller, cell_pa);
  stage.back = read_demand(table, "back", programme.back_controller, back_pa);
  stage.time_limit_s =
      60 * table.maybe_number("time_limit_min", {.above = 0, .at_most = 1e5}).value_or(1440);
  const toml::array* ends = table.maybe_array("end");
  if (ends == nullptr || ends->empty())
    table.fail("",
               fmt::format("the stage {} has no end; write end = [{{quantity = \"q_kPa\", above "
                           "= 30}}]",
                           stage.name));
  for (const toml::node& node : *ends) {
    const toml::table* end = node.as_table();
    if (end == nullptr) table.fail("end", "must be a list of {quantity, above or below}");
    stage.end.push_back(read_end(StrictTable(*end, programme.source, "[end]")));
  }
  table.done();
  check_ends(table, stage, programme, cell_pa, back_pa);
  cell_pa = pressure_after(stage, stage.cell, EndQuantity::cell_pressure, cell_pa);
  back_pa = pressure_after(stage, stage.back, EndQuantity::back_pressure, back_pa);
  return stage;
}

}  // namespace triax::lab
