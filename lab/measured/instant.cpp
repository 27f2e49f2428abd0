// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/instant.hpp"

#include <cmath>

namespace triax::lab {
namespace {

std::optional<double> known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

Instant instant_of(const State& s, bool has_time) {
  return {.reading = s.reading,
          .time_s = has_time ? known(s.time_s) : std::nullopt,
          .axial_strain = known(s.strain.axial),
          .q_pa = known(s.q),
          .p_eff_pa = known(s.p_eff),
          .pore_pressure_pa = known(s.pore_pressure)};
}

Instant instant_of(const PathPoint& p, bool has_time) {
  return {.reading = std::llround(p.reading),
          .time_s = has_time ? known(p.progress) : std::nullopt,
          .axial_strain = known(p.axial_strain),
          .q_pa = known(p.q),
          .p_eff_pa = known(p.p_eff),
          .pore_pressure_pa = known(p.pore_pressure)};
}

Moment moment_of(const State& s, bool has_time) {
  return {s.reading, has_time ? known(s.time_s) : std::nullopt};
}

}  // namespace triax::lab
