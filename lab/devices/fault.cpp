// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "lab/devices/spoken_unit.hpp"

namespace triax::lab {
namespace {

using enum FaultKind;

constexpr auto kNames = std::to_array<std::pair<FaultKind, std::string_view>>({
    {stuck, "stuck"},
    {open_circuit, "open_circuit"},
    {spike, "spike"},
    {drop_out, "drop_out"},
    {drift, "drift"},
    {latency, "latency"},
    {full, "full"},
    {empty, "empty"},
    {leak, "leak"},
    {does_not_close, "does_not_close"},
    {does_not_open, "does_not_open"},
});

constexpr std::array kOfChannels{stuck, open_circuit, spike, drop_out, drift, latency};
constexpr std::array kOfControllers{stuck, full, empty, leak};
constexpr std::array kOfFrame{stuck};
constexpr std::array kOfValve{does_not_close, does_not_open};

std::optional<Quantity> channel(std::string_view device) {
  const auto quantity = find_quantity(device);
  return quantity && is_raw(*quantity) ? quantity : std::nullopt;
}

std::string size_in_words(const Fault& fault) {
  if (fault.kind == latency) return fmt::format(" of {:g} s", fault.size);
  if (fault.kind == leak) return fmt::format(" of {:g} mm3/min at 100 kPa", fault.size * 6e15);
  const auto quantity = channel(fault.device);
  if (!quantity || (fault.kind != spike && fault.kind != drift)) return "";
  const sim::Unit unit = spoken_unit(*quantity);
  return fault.kind == spike
             ? fmt::format(" of ±{:g} {}", fault.size / unit.scale, unit.name)
             : fmt::format(" of {:g} {}/min", fault.size * 60 / unit.scale, unit.name);
}

}  // namespace

std::string_view to_string(FaultKind kind) {
  return std::ranges::find(kNames, kind, &std::pair<FaultKind, std::string_view>::first)->second;
}

const std::vector<std::string>& fault_devices() {
  static const std::vector<std::string> devices = [] {
    std::vector<std::string> names;
    for (const auto& row : quantities().first(kRawQuantityCount)) names.emplace_back(row.name);
    names.insert(names.end(), {"cell_controller", "back_controller", "frame", "valve"});
    return names;
  }();
  return devices;
}

std::span<const FaultKind> possible_faults(std::string_view device) {
  if (channel(device)) return kOfChannels;
  if (device == "cell_controller" || device == "back_controller") return kOfControllers;
  if (device == "frame") return kOfFrame;
  if (device == "valve") return kOfValve;
  return {};
}

std::string describe(const Fault& fault) {
  std::string kind(to_string(fault.kind));
  std::ranges::replace(kind, '_', ' ');
  const std::string until = fault.until_s ? fmt::format(" to {:g} s", *fault.until_s) : "";
  return fmt::format("simulated fault: {} {}{} from {:g} s{}", fault.device, kind,
                     size_in_words(fault), fault.from_s, until);
}

std::vector<Fault> active_faults(const std::vector<Fault>& faults, std::string_view device,
                                 double time_s) {
  std::vector<Fault> found;
  for (const Fault& fault : faults)
    if (fault.device == device && fault.active(time_s)) found.push_back(fault);
  return found;
}

bool holds(const std::vector<Fault>& faults, FaultKind kind) {
  return std::ranges::any_of(faults, [&](const Fault& fault) { return fault.kind == kind; });
}

}  // namespace triax::lab
