// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What lies ahead of a test while it runs: the onset to come, as the readings so far have it.
#include <cstdint>
#include <optional>
#include <string_view>

#include "lab/results/quantity.hpp"

namespace triax::lab {

/// `approaching`: an onset is forecast. `imminent`: the onset is within the next few readings at
/// the present rate, or it was passed within the error of its forecast. In cyclic tests: the
/// specimen probably fails within one load cycle. `lost`: the onset was passed.
enum class WarningLevel { none, approaching, imminent, lost };
/// "imminent".
std::string_view to_string(WarningLevel level);
std::optional<WarningLevel> warning_level_from(std::string_view text);

/// What is left of the quantity that drives the test: deviator stress under load, axial strain
/// under displacement, mean effective stress at held q. SI, never negative.
struct LeftToOnset {
  Quantity quantity = Quantity::axial_strain;
  double value = 0;
  std::optional<double> time_s;  ///< at the present rate; empty without time
};

/// `left.value` in the unit of its quantity's column ("deviator_stress_kPa"), and back.
double in_field_units(const LeftToOnset& left);
double from_field_units(Quantity quantity, double value);

inline constexpr double kOf90 = 1.645;  ///< standard errors on each side of a 90 % interval

/// Of an undrained cyclic test (lab/warning/cyclic_warning.hpp).
struct CyclicForecast {
  double probability = 0;  ///< of failure within one load cycle
  double load_cycles = 0;  ///< applied so far, in halves
};

/// A forecast, and when it was made. With `cyclic` it has no η.
struct Forecast {
  std::int64_t reading = 0;  ///< the last that had been taken
  std::optional<double> time_s;
  double eta = 0;                        ///< at the onset, negative in extension, NaN with `cyclic`
  double eta_low = 0, eta_high = 0;      ///< its 90 % interval
  std::optional<LeftToOnset> left;       ///< empty where the path does not go there now
  std::optional<CyclicForecast> cyclic;  ///< empty: a forecast of η
};

}  // namespace triax::lab
