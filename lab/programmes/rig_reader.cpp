// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/rig_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lab/base/bad_input.hpp"
#include "lab/base/bounds.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/programmes/absent_or.hpp"
#include "lab/programmes/instrument_set.hpp"
#include "lab/programmes/transducer_reader.hpp"

namespace triax::lab {
namespace {

constexpr double kMmPerMin = 1e-3 / 60;
constexpr Bounds kPositive{.above = 0};
constexpr Bounds kNotNegative{.at_least = 0};
constexpr Bounds kPressure_kPa{.above = 0, .at_most = kLargestPressure_kPa};

/// Sets `member` to scale · (the key's value) where the key is there.
void set(const TomlTable& table, const char* key, const Bounds& bounds, double scale,
         double& member) {
  if (const auto value = table.number(key, bounds)) member = *value * scale;
}

/// The same for what may be 0, that is absent.
void set_or_absent(const TomlTable& table, const char* key, double smallest, double largest,
                   double scale, double& member) {
  if (const auto value = absent_or(table, key, smallest, largest)) member = *value * scale;
}

void read_over(PressureController& c, const TomlTable& table) {
  set(table, "range_kPa", kPressure_kPa, 1e3, c.range_pa);
  set(table, "rate_limit_kPa_per_min", kPositive, 1e3 / 60, c.rate_limit_pa_per_s);
  set_or_absent(table, "pressure_resolution_kPa", 1e-6, 1e4, 1e3, c.pressure_resolution_pa);
  set_or_absent(table, "time_constant_s", 1e-3, 3600, 1, c.time_constant_s);
  set_or_absent(table, "fluid_compliance_mm3_per_kPa", 1e-3, 1e4, 1e-12,
                c.fluid_compliance_m3_per_pa);
  set_or_absent(table, "capacity_cm3", 1e-3, 1e6, 1e-6, c.capacity_m3);
  if (const auto start = table.number("start_volume_cm3", {.at_least = 0, .at_most = 1e6}))
    c.start_volume_m3 = 1e-6 * *start;
  set_or_absent(table, "volume_rate_limit_mm3_per_s", 1e-6, 1e6, 1e-9,
                c.volume_rate_limit_m3_per_s);
  set_or_absent(table, "leak_mm3_per_min_at_100kPa", 1e-6, 1e6, 1e-9 / 60 / 100e3,
                c.leak_m3_per_s_per_pa);
  table.finish();
}

PressureController read_controller(const std::optional<TomlTable>& base,
                                   const std::optional<TomlTable>& own) {
  PressureController c{.range_pa = 3e6, .rate_limit_pa_per_s = 10e3};
  if (base) read_over(c, *base);
  if (own) read_over(c, *own);
  if (!base && !own) return c;
  const TomlTable& table = own ? *own : *base;
  if (c.pressure_resolution_pa > c.range_pa)
    table.fail("pressure_resolution_kPa", "is coarser than the range");
  if (c.volume_rate_limit_m3_per_s > 0 && c.fluid_compliance_m3_per_pa == 0)
    table.fail("volume_rate_limit_mm3_per_s", "needs fluid_compliance_mm3_per_kPa as well");
  if (c.start_volume_m3 && c.capacity_m3 == 0)
    table.fail("start_volume_cm3", "needs capacity_cm3 as well");
  if (c.start_volume_m3 && *c.start_volume_m3 > c.capacity_m3)
    table.fail("start_volume_cm3",
               fmt::format("is more than the capacity of {:g} cm3", c.capacity_m3 * 1e6));
  return c;
}

void read_over(LoadingFrame& f, const TomlTable& table) {
  set(table, "slowest_mm_per_min", kPositive, kMmPerMin, f.slowest_m_per_s);
  set(table, "fastest_mm_per_min", kPositive, kMmPerMin, f.fastest_m_per_s);
  set_or_absent(table, "velocity_step_mm_per_min", 1e-9, 1e3, kMmPerMin, f.velocity_step_m_per_s);
  set(table, "travel_mm", kPositive, 1e-3, f.travel_m);
  set_or_absent(table, "stiffness_kN_per_mm", 1e-3, 1e6, 1e6, f.stiffness_n_per_m);
  set_or_absent(table, "load_cell_stiffness_kN_per_mm", 1e-3, 1e6, 1e6,
                f.load_cell_stiffness_n_per_m);
  set_or_absent(table, "load_limit_N", 1e-3, 1e9, 1, f.load_limit_n);
  set_or_absent(table, "bandwidth_Hz", 1e-4, 1e4, 1, f.bandwidth_hz);
  set_or_absent(table, "servo_filter_s", 1e-3, 1e4, 1, f.servo_filter_s);
  set_or_absent(table, "moving_mass_kg", 1e-3, 1e4, 1, f.moving_mass_kg);
  set_or_absent(table, "damping_N_s_per_m", 1e-6, 1e9, 1, f.damping_n_s_per_m);
  table.finish();
}

LoadingFrame read_frame(const std::optional<TomlTable>& base, const std::optional<TomlTable>& own) {
  LoadingFrame f{.slowest_m_per_s = 0.00001 * kMmPerMin,
                 .fastest_m_per_s = 5.99999 * kMmPerMin,
                 .travel_m = 0.05,
                 .moving_mass_kg = 5,
                 .damping_n_s_per_m = 50};
  if (base) read_over(f, *base);
  if (own) read_over(f, *own);
  if (!base && !own) return f;
  const TomlTable& table = own ? *own : *base;
  if (f.slowest_m_per_s > f.fastest_m_per_s)
    table.fail("slowest_mm_per_min", "is above fastest_mm_per_min");
  if (f.velocity_step_m_per_s > f.fastest_m_per_s)
    table.fail("velocity_step_mm_per_min", "is above fastest_mm_per_min");
  return f;
}

/// Controllers and specimen take turns in ticks of 0.25 s: what flows through the drainage within
/// one must not move a controller's pressure by more than what drives the flow, or the two would
/// swing.
void check_turns(const TomlTable& table, const Programme& programme) {
  constexpr double kShortest_s = 0.25;
  double compliance = std::numeric_limits<double>::infinity();
  for (const PressureController* c : {&programme.cell_controller, &programme.back_controller})
    if (c->fluid_compliance_m3_per_pa > 0)
      compliance = std::min(compliance, c->fluid_compliance_m3_per_pa);
  const double least = kShortest_s / compliance;
  if (programme.specimen.drainage_resistance < least * (1 - 1e-9))
    table.fail("drainage_resistance_kPa_s_per_mm3",
               fmt::format("must be at least {:.3g} with a controller of fluid compliance of "
                           "{:g} mm3/kPa",
                           least * 1e-12, compliance * 1e12));
}

std::optional<TomlTable> inner(const std::optional<TomlTable>& table, std::string_view key) {
  return table ? table->table(key) : std::nullopt;
}

void read_transducers(const std::optional<TomlTable>& base, const std::optional<TomlTable>& own,
                      Programme& programme) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    const QuantityInfo& row = quantities()[i];
    const auto shipped = inner(base, row.name), given = inner(own, row.name);
    programme.transducers[i] = read_transducer(row.quantity, shipped, given);
    programme.fitted[i] = row.raw.standard || shipped || given;
  }
  if (base) base->finish();
  if (own) own->finish();
}

std::optional<TomlTable> read_instruments(const TomlTable& table) {
  const auto name = table.text("instruments");
  if (!name) return std::nullopt;
  try {
    return find_instruments(*name);
  } catch (const BadInput& error) {
    table.fail("instruments", error.what());
  }
}

}  // namespace

void read_rig(const TomlTable& table, Programme& programme) {
  const auto base = read_instruments(table);
  const auto both = [&](const auto& read, const char* key) {
    return read(inner(base, key), table.table(key));
  };
  programme.cell_controller = both(read_controller, "cell_controller");
  programme.back_controller = both(read_controller, "back_controller");
  programme.frame = both(read_frame, "frame");
  read_transducers(inner(base, "transducers"), table.table("transducers"), programme);
  if (base) base->finish();
  const double highest =
      std::min(programme.back_controller.range_pa,
               programme.cell_controller.range_pa - programme.initial_effective_stress_pa) /
      1e3;
  programme.initial_back_pressure_pa =
      1e3 * table.required_number("back_pressure_kPa", {.at_least = 0, .at_most = highest});
  sim::SpecimenProperties& specimen = programme.specimen;
  if (const auto modulus = table.number("water_bulk_modulus_GPa", kPositive))
    specimen.water_compressibility = 1e-9 / *modulus;
  set(table, "system_compliance_mm3_per_kPa", kNotNegative, 1e-12, specimen.system_compliance);
  set(table, "drainage_resistance_kPa_s_per_mm3", kNotNegative, 1e12, specimen.drainage_resistance);
  table.finish();
  check_turns(table, programme);
}

}  // namespace triax::lab
