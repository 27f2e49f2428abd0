// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/fault_reader.hpp"

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/devices/spoken_unit.hpp"

namespace triax::lab {
namespace {

/// Latest time that a programme can speak of, 19 years.
constexpr double kLatest_s = 6e8;
/// Latency in readings that a channel can keep.
constexpr double kLongestLatency = 60;

std::string read_device(const TomlTable& table) {
  std::string word = table.required_text("device");
  if (possible_faults(word).empty()) table.fail("device", invalid_value(word, fault_devices()));
  return word;
}

FaultKind read_kind(const TomlTable& table, const std::string& device) {
  const std::string word = table.required_text("kind");
  std::vector<std::string> known;
  for (const FaultKind kind : possible_faults(device)) {
    if (to_string(kind) == word) return kind;
    known.emplace_back(to_string(kind));
  }
  table.fail("kind", fmt::format("{} is not a fault of {}; {}", excerpt(word), device,
                                 suggestion(word, known)));
}

/// "NAME_min" or "NAME_s", in seconds.
std::optional<double> read_time(const TomlTable& table, const std::string& name) {
  const auto minutes = table.number(name + "_min", {.at_least = 0, .at_most = kLatest_s / 60});
  const auto seconds = table.number(name + "_s", {.at_least = 0, .at_most = kLatest_s});
  if (minutes && seconds)
    table.fail(name + "_s", fmt::format("give either {0}_min or {0}_s", name));
  return minutes ? 60 * *minutes : seconds;
}

double read_size(const TomlTable& table, const Fault& fault, const Programme& programme) {
  const Bounds positive{.above = 0, .at_most = 1e9};
  switch (fault.kind) {
    case FaultKind::leak:
      return 1e-9 / 60 / 100e3 * table.required_number("leak_mm3_per_min_at_100kPa", positive);
    case FaultKind::latency:
      return table.required_number(
          "latency_s", {.above = 0, .at_most = kLongestLatency * programme.logging.interval_s});
    case FaultKind::spike: {
      const sim::Unit unit = spoken_unit(*find_quantity(fault.device));
      return unit.scale * table.required_number(fmt::format("spike_{}", unit.name), positive);
    }
    case FaultKind::drift: {
      const sim::Unit unit = spoken_unit(*find_quantity(fault.device));
      const std::string key = fmt::format("drift_{}_per_min", unit.name);
      const double drift = table.required_number(key, {.at_least = -1e9, .at_most = 1e9});
      if (drift == 0) table.fail(key, "is 0; leave the fault out");
      return unit.scale / 60 * drift;
    }
    default:
      return 0;
  }
}

}  // namespace

Fault read_fault(const TomlTable& table, const Programme& programme) {
  Fault fault;
  fault.device = read_device(table);
  fault.kind = read_kind(table, fault.device);
  const auto from = read_time(table, "from");
  fault.until_s = read_time(table, "until");
  fault.size = read_size(table, fault, programme);
  table.finish();
  if (!from) table.fail("", "from_min or from_s is missing: the test time at which it begins");
  fault.from_s = *from;
  if (fault.until_s && *fault.until_s <= fault.from_s)
    table.fail(table.has("until_s") ? "until_s" : "until_min", "is not after the fault's start");
  if (fault.kind == FaultKind::open_circuit) {
    const Quantity channel = *find_quantity(fault.device);
    if (programme.transducers[index(channel)].range == 0)
      table.fail("kind", fmt::format("an open circuit reads the end of the range: it needs "
                                     "range_{} in [rig.transducers.{}]",
                                     spoken_unit(channel).name, fault.device));
  }
  return fault;
}

}  // namespace triax::lab
