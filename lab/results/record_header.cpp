#include "lab/results/record_header.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace triax::lab {
namespace {

template <class Enum>
using Names = std::span<const std::pair<Enum, std::string_view>>;

template <class Enum>
std::string_view name_of(Enum value, Names<Enum> names) {
  for (const auto& [key, name] : names)
    if (key == value) return name;
  return {};
}

template <class Enum>
std::optional<Enum> value_of(std::string_view text, Names<Enum> names) {
  for (const auto& [key, name] : names)
    if (name == text) return key;
  return std::nullopt;
}

constexpr auto kRoles = std::to_array<std::pair<StageRole, std::string_view>>(
    {{StageRole::unknown, "unknown"},
     {StageRole::saturation, "saturation"},
     {StageRole::b_check, "b_check"},
     {StageRole::consolidation, "consolidation"},
     {StageRole::shear, "shear"},
     {StageRole::hold, "hold"}});
constexpr auto kDrainages = std::to_array<std::pair<Drainage, std::string_view>>(
    {{Drainage::unknown, "unknown"}, {Drainage::open, "open"}, {Drainage::closed, "closed"}});
constexpr auto kControls = std::to_array<std::pair<AxialControl, std::string_view>>(
    {{AxialControl::unknown, "unknown"},
     {AxialControl::displacement, "displacement"},
     {AxialControl::load, "load"},
     {AxialControl::constant_q, "constant_q"}});

}  // namespace

std::string_view to_string(Origin origin) {
  return origin == Origin::simulated ? "simulated" : "recorded";
}
std::string_view to_string(StageRole role) { return name_of<StageRole>(role, kRoles); }
std::string_view to_string(Drainage drainage) { return name_of<Drainage>(drainage, kDrainages); }
std::string_view to_string(AxialControl control) {
  return name_of<AxialControl>(control, kControls);
}
std::optional<StageRole> stage_role_from(std::string_view text) {
  return value_of<StageRole>(text, kRoles);
}
std::optional<Drainage> drainage_from(std::string_view text) {
  return value_of<Drainage>(text, kDrainages);
}
std::optional<AxialControl> axial_control_from(std::string_view text) {
  return value_of<AxialControl>(text, kControls);
}

bool RecordHeader::has(Quantity column) const {
  return std::ranges::find(columns, column) != columns.end();
}

bool RecordHeader::is_raw() const {
  return has(Quantity::axial_displacement) && has(Quantity::axial_force) &&
         has(Quantity::cell_pressure);
}

const StageInfo* RecordHeader::stage(int number) const {
  const auto found = std::ranges::find(stages, number, &StageInfo::number);
  return found == stages.end() ? nullptr : &*found;
}

}  // namespace triax::lab
