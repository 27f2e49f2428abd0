// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/sensor_finding.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

std::string_view plain_name(Quantity channel) {
  const std::string_view sensor = info(channel).raw.sensor;
  return sensor.empty() ? "the column" : sensor;
}

std::string value_in_field_units(const SensorFinding& f) {
  const std::string_view unit = info(f.channel).unit;
  const auto known = sim::find_unit(unit);
  const double value = known ? f.value_si / known->scale : f.value_si;
  return unit.empty() ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

std::string when(const SensorFinding& f) {
  std::string text = fmt::format("reading {}", f.from);
  if (f.from_time_s) text += fmt::format(" ({:.6g} s)", *f.from_time_s);
  if (!f.until) return "from " + text + " on";
  return *f.until == f.from ? "at " + text : fmt::format("from {} to {}", text, *f.until);
}

}  // namespace

std::string_view to_string(SensorFault fault) {
  switch (fault) {
    case SensorFault::missing:
      return "missing";
    case SensorFault::saturated:
      return "saturated";
    case SensorFault::stuck:
      return "stuck";
    case SensorFault::spike:
      return "spike";
  }
  return "";
}

std::string sensor_name(Quantity channel) {
  return fmt::format("{} ({})", plain_name(channel), info(channel).name);
}

std::string reason(const SensorFinding& f) {
  switch (f.fault) {
    case SensorFault::missing:
      return sensor_name(f.channel) + " gives no readings";
    case SensorFault::saturated:
      return sensor_name(f.channel) + " is saturated";
    case SensorFault::stuck:
      return sensor_name(f.channel) + " is stuck";
    case SensorFault::spike:
      return sensor_name(f.channel) + " gave a spike";
  }
  return "";
}

bool is_vouched(const SensorFinding& finding, const std::vector<Quantity>& vouched) {
  return finding.fault != SensorFault::missing &&
         std::ranges::find(vouched, finding.channel) != vouched.end();
}

std::string describe(const SensorFinding& f) {
  switch (f.fault) {
    case SensorFault::missing:
      return fmt::format("{} {}", reason(f), when(f));
    case SensorFault::saturated:
      return fmt::format("{}: jumped to {} and stays there, open circuit or overload, {}",
                         reason(f), value_in_field_units(f), when(f));
    case SensorFault::stuck:
      return fmt::format("{} at {} {}", reason(f), value_in_field_units(f), when(f));
    case SensorFault::spike:
      return fmt::format("{} of {} {}", reason(f), value_in_field_units(f), when(f));
  }
  return "";
}

}  // namespace triax::lab
