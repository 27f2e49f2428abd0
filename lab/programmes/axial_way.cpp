// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/axial_way.hpp"

#include <fmt/format.h>

#include "lab/base/bounds.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/programmes/programme.hpp"

namespace triax::lab {
namespace {

/// A rate; `at_rest` is the word for an axis that has none.
double read_rate(const TomlTable& table, std::string_view key, std::string_view at_rest) {
  const double value = table.required_number(key);
  if (value == 0)
    table.fail(key, fmt::format("is 0; give a rate or write axial = \"{}\"", at_rest));
  return value;
}

double read_velocity(const TomlTable& table, const LoadingFrame& frame) {
  const double velocity = read_rate(table, "axial_rate_mm_per_min", "hold") * 1e-3 / 60;
  if (!gives(frame, velocity))
    table.fail("axial_rate_mm_per_min",
               fmt::format("the frame gives {:g} to {:g} mm/min", frame.slowest_m_per_s * 6e4,
                           frame.fastest_m_per_s * 6e4));
  return velocity;
}

void read_displacement(const TomlTable& table, const LoadingFrame& frame, Stage& stage) {
  stage.axial_rate_m_per_s = read_velocity(table, frame);
  stage.strain_path_R = table.number("strain_path_R", {.at_least = 0.05, .at_most = 20});
}

void read_spring(const TomlTable& table, const LoadingFrame& frame, Stage& stage) {
  stage.spring_stiffness_n_per_m =
      1e3 * table.required_number("spring_stiffness_N_per_mm", {.above = 0, .at_most = 1e7});
  stage.axial_rate_m_per_s = read_velocity(table, frame);
}

void read_load(const TomlTable& table, const LoadingFrame&, Stage& stage) {
  stage.load_rate_n_per_s = read_rate(table, "load_rate_N_per_min", "dead_load") / 60;
}

void read_held_q(const TomlTable& table, const LoadingFrame&, Stage& stage) {
  if (const auto q = table.number(
          "held_q_kPa", {.at_least = -kLargestPressure_kPa, .at_most = kLargestPressure_kPa}))
    stage.held_q_pa = 1e3 * *q;
}

void read_held_ratio(const TomlTable& table, const LoadingFrame&, Stage& stage) {
  // q/p' lies between those of σ₁' = 0 and σ₃' = 0.
  stage.held_stress_ratio =
      table.required_number("held_stress_ratio", {.at_least = -1.49, .at_most = 2.99});
}

double ramp(const Stage& stage, const AxisView& view) {
  return view.force_at_start_n + stage.load_step_n + stage.load_rate_n_per_s * view.stage_time_s;
}

double held_q(const Stage& stage, const AxisView& view) {
  return stage.held_q_pa.value_or(view.q_at_start_pa);
}

/// q = η p′ with p′ = σ₃′ + q/3.
double held_ratio(const Stage& stage, const AxisView& view) {
  const double eta = stage.held_stress_ratio;
  return eta * (view.cell_pa - view.pore_pa) / (1 - eta / 3);
}

std::vector<AxialWay> make_ways() {
  using Q = Quantity;
  using enum AxialAction;
  using enum AxialWay::Drive;
  const std::vector<Quantity> on_area = {Q::axial_force, Q::axial_displacement, Q::back_volume};
  return {
      {.action = free, .word = "free"},
      {.action = hold, .word = "hold", .drive = crosshead, .control = AxialControl::displacement},
      {.action = displacement,
       .word = "displacement",
       .drive = crosshead,
       .control = AxialControl::displacement,
       .read = read_displacement},
      {.action = spring, .word = "spring", .drive = crosshead, .read = read_spring},
      {.action = load,
       .word = "load",
       .drive = servo,
       .read = read_load,
       .looks_at = {Q::axial_force},
       .force = ramp},
      {.action = dead_load, .word = "dead_load", .drive = masses},
      {.action = constant_q,
       .word = "constant_q",
       .drive = servo,
       .control = AxialControl::constant_q,
       .read = read_held_q,
       .looks_at = on_area,
       .stress = held_q},
      {.action = stress_ratio,
       .word = "stress_ratio",
       .drive = servo,
       .read = read_held_ratio,
       .looks_at = {Q::axial_force, Q::axial_displacement, Q::back_volume, Q::pore_pressure},
       .stress = held_ratio},
  };
}

}  // namespace

std::span<const AxialWay> axial_ways() {
  static const std::vector<AxialWay> ways = make_ways();
  return ways;
}

const AxialWay& way_of(AxialAction action) {
  return axial_ways()[static_cast<std::size_t>(action)];
}

bool by_force(AxialAction action) {
  const auto drive = way_of(action).drive;
  return drive == AxialWay::Drive::servo || drive == AxialWay::Drive::masses;
}

}  // namespace triax::lab
