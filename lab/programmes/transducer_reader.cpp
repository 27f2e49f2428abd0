// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/transducer_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "lab/base/bounds.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/devices/spoken_unit.hpp"
#include "lab/programmes/absent_or.hpp"
#include "lab/programmes/programme.hpp"

namespace triax::lab {
namespace {

constexpr double kLargest = 1e9;
constexpr Bounds kAmount{.at_least = 0, .at_most = kLargest};
constexpr Bounds kEitherSign{.at_least = -kLargest, .at_most = kLargest};
/// Beyond 25 % a non-linear instrument would turn round.
constexpr Bounds kBend{.at_least = -20, .at_most = 20};
constexpr Bounds kWidth{.at_least = 0, .at_most = 20};

/// What is said of a transducer, in the unit in which one speaks of it.
struct Sheet {
  std::string unit;
  bool pressure = false;
  double range = 0, resolution = 0, noise = 0, offset = 0, drift_per_h = 0;
  std::int64_t bits = 0;  ///< 0: not given
  double time_constant_s = 0, hysteresis_pct = 0, nonlinearity_pct = 0;
  double sensitivity_mV = 0, sampling_interval_s = 0;
  std::vector<double> calibration;
};

void read_over(Sheet& sheet, const TomlTable& table) {
  const auto set = [&](const std::string& key, const Bounds& bounds, double& member) {
    if (const auto value = table.number(key, bounds)) member = *value;
  };
  const auto set_or_absent = [&](const std::string& key, double smallest, double largest,
                                 double& member) {
    if (const auto value = absent_or(table, key, smallest, largest)) member = *value;
  };
  const std::string& unit = sheet.unit;
  const auto bits = table.integer("bits", 4, 32);
  if (bits && table.has("resolution_" + unit))
    table.fail("bits", fmt::format("give either bits or resolution_{}", unit));
  if (bits) {
    sheet.bits = *bits;
    sheet.resolution = 0;
  } else if (table.has("resolution_" + unit)) {
    sheet.bits = 0;
  }
  set("range_" + unit, {.above = 0, .at_most = sheet.pressure ? kLargestPressure_kPa : kLargest},
      sheet.range);
  set_or_absent("resolution_" + unit, 1e-9, kLargest, sheet.resolution);
  set("noise_" + unit, kAmount, sheet.noise);
  set("offset_" + unit, kEitherSign, sheet.offset);
  set(fmt::format("drift_{}_per_h", unit), kEitherSign, sheet.drift_per_h);
  set_or_absent("time_constant_s", 1e-3, 3600, sheet.time_constant_s);
  set("hysteresis_pct_of_range", kWidth, sheet.hysteresis_pct);
  set("nonlinearity_pct_of_range", kBend, sheet.nonlinearity_pct);
  set_or_absent("sensitivity_mV", 1e-3, 1e6, sheet.sensitivity_mV);
  set_or_absent("sampling_interval_s", 1e-4, 3600, sheet.sampling_interval_s);
  const std::string polynomial = fmt::format("calibration_{}_of_mV", unit);
  if (auto calibration = table.numbers(polynomial); table.has(polynomial)) {
    if (calibration.size() == 1 || calibration.size() > 8)
      table.fail(polynomial, "must be 2 to 8 numbers: [c0, c1, ...] of c0 + c1 v + c2 v² ...");
    sheet.calibration = std::move(calibration);
  }
  table.finish();
}

/// What cannot be judged key by key.
void check(const Sheet& sheet, const TomlTable& table) {
  const std::string& unit = sheet.unit;
  const auto needs = [&](bool given, bool there, const std::string& key, const std::string& other) {
    if (given && !there) table.fail(key, fmt::format("needs {} as well", other));
  };
  const bool ranged = sheet.range > 0;
  const std::string range = "range_" + unit;
  const std::string polynomial = fmt::format("calibration_{}_of_mV", unit);
  needs(sheet.bits > 0, ranged, "bits", range);
  needs(sheet.hysteresis_pct > 0, ranged, "hysteresis_pct_of_range", range);
  needs(sheet.nonlinearity_pct != 0, ranged, "nonlinearity_pct_of_range", range);
  needs(sheet.sensitivity_mV > 0, ranged, "sensitivity_mV", range);
  needs(!sheet.calibration.empty(), sheet.sensitivity_mV > 0, polynomial, "sensitivity_mV");
  if (ranged && sheet.resolution > sheet.range)
    table.fail("resolution_" + unit, "is coarser than the range");
  double largest = 0, power = 1;
  for (const double c : sheet.calibration) {
    largest += std::abs(c) * power;
    power *= sheet.sensitivity_mV;
  }
  // Written so that a sum that is no number is caught too.
  if (!sheet.calibration.empty() && !(largest <= 1000 * sheet.range))
    table.fail(polynomial, fmt::format("can give {:g} {} at full scale, beyond the range of {:g} "
                                       "{}; expected a polynomial of the signal in mV",
                                       largest, unit, sheet.range, unit));
}

}  // namespace

Transducer read_transducer(Quantity channel, const std::optional<TomlTable>& base,
                           const std::optional<TomlTable>& own) {
  Transducer t;
  t.unit = *sim::find_unit(info(channel).unit);
  const sim::Unit spoken = spoken_unit(channel);
  Sheet sheet;
  sheet.unit = spoken.name;
  sheet.pressure = spoken.dimension == sim::Dimension::pressure;
  if (base) read_over(sheet, *base);
  if (own) read_over(sheet, *own);
  if (base || own) check(sheet, own ? *own : *base);
  // Exactly 1, or 1e-3 for a load cell.
  const double scale = spoken.scale / t.unit.scale;
  t.range = scale * sheet.range;
  t.step = sheet.bits > 0 ? converter_step(t.range, static_cast<int>(sheet.bits))
                          : scale * sheet.resolution;
  t.noise_rms = scale * sheet.noise;
  t.offset = scale * sheet.offset;
  t.drift_per_hour = scale * sheet.drift_per_h;
  t.time_constant_s = sheet.time_constant_s;
  t.hysteresis = sheet.hysteresis_pct / 100 * t.range / 2;
  t.nonlinearity = sheet.nonlinearity_pct / 100 * t.range;
  t.sensitivity_mV = sheet.sensitivity_mV;
  for (const double c : sheet.calibration) t.calibration.push_back(scale * c);
  t.sampling_interval_s = sheet.sampling_interval_s;
  return t;
}

}  // namespace triax::lab
