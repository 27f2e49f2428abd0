#include "lab/programmes/rig_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/programmes/instrument_set.hpp"
#include "lab/programmes/transducer_reader.hpp"
#include "lab/records/bad_input.hpp"
#include "lab/records/toml_reader.hpp"

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

void read_over(PressureController& c, const TomlTable& table) {
  const Bounds volume_cm3{.above = 0, .at_most = 1e6};
  set(table, "range_kPa", kPressure_kPa, 1e3, c.range_pa);
  set(table, "rate_limit_kPa_per_min", kPositive, 1e3 / 60, c.rate_limit_pa_per_s);
  set(table, "pressure_resolution_kPa", kNotNegative, 1e3, c.pressure_resolution_pa);
  set(table, "time_constant_s", {.at_least = 0, .at_most = 3600}, 1, c.time_constant_s);
  set(table, "fluid_compliance_mm3_per_kPa", {.at_least = 0, .at_most = 1e6}, 1e-12,
      c.fluid_compliance_m3_per_pa);
  set(table, "capacity_cm3", volume_cm3, 1e-6, c.capacity_m3);
  if (const auto start = table.number("start_volume_cm3", {.at_least = 0, .at_most = 1e6}))
    c.start_volume_m3 = 1e-6 * *start;
  set(table, "volume_rate_limit_mm3_per_s", kPositive, 1e-9, c.volume_rate_limit_m3_per_s);
  set(table, "leak_mm3_per_min_at_100kPa", kNotNegative, 1e-9 / 60 / 100e3, c.leak_m3_per_s_per_pa);
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
    table.fail("volume_rate_limit_mm3_per_s",
               "needs fluid_compliance_mm3_per_kPa beside it: without it the pressure is held "
               "against any flow");
  if (c.start_volume_m3 && c.capacity_m3 == 0)
    table.fail("start_volume_cm3", "needs capacity_cm3 beside it");
  if (c.start_volume_m3 && *c.start_volume_m3 > c.capacity_m3)
    table.fail("start_volume_cm3",
               fmt::format("is more than the capacity of {:g} cm3", c.capacity_m3 * 1e6));
  return c;
}

void read_over(LoadingFrame& f, const TomlTable& table) {
  set(table, "slowest_mm_per_min", kPositive, kMmPerMin, f.slowest_m_per_s);
  set(table, "fastest_mm_per_min", kPositive, kMmPerMin, f.fastest_m_per_s);
  set(table, "velocity_step_mm_per_min", kNotNegative, kMmPerMin, f.velocity_step_m_per_s);
  set(table, "travel_mm", kPositive, 1e-3, f.travel_m);
  set(table, "stiffness_kN_per_mm", {.above = 0, .at_most = 1e6}, 1e6, f.stiffness_n_per_m);
  set(table, "load_cell_stiffness_kN_per_mm", {.above = 0, .at_most = 1e6}, 1e6,
      f.load_cell_stiffness_n_per_m);
  set(table, "load_limit_N", kPositive, 1, f.load_limit_n);
  set(table, "servo_gain_mm_per_min_per_N", kPositive, kMmPerMin, f.servo_gain_m_per_s_per_n);
  set(table, "bandwidth_Hz", {.above = 0, .at_most = 1e6}, 1, f.bandwidth_hz);
  set(table, "moving_mass_kg", {.at_least = 0, .at_most = 1e4}, 1, f.moving_mass_kg);
  set(table, "damping_N_s_per_m", {.at_least = 0, .at_most = 1e9}, 1, f.damping_n_s_per_m);
  table.finish();
}

LoadingFrame read_frame(const std::optional<TomlTable>& base, const std::optional<TomlTable>& own) {
  LoadingFrame f{.slowest_m_per_s = 0.00001 * kMmPerMin,
                 .fastest_m_per_s = 5.99999 * kMmPerMin,
                 .travel_m = 0.05,
                 .servo_gain_m_per_s_per_n = 6 * kMmPerMin,
                 .moving_mass_kg = 5};
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

std::optional<TomlTable> inner(const std::optional<TomlTable>& table, std::string_view key) {
  return table ? table->table(key) : std::nullopt;
}

void read_transducers(const std::optional<TomlTable>& base, const std::optional<TomlTable>& own,
                      Programme& programme) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    const QuantityInfo& row = quantities()[i];
    programme.transducers[i] =
        read_transducer(row.quantity, inner(base, row.name), inner(own, row.name));
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
}

}  // namespace triax::lab
