// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/record_header.hpp"

#include <algorithm>
#include <array>

#include "lab/base/names.hpp"
#include "lab/results/test_type.hpp"

namespace triax::lab {
namespace {

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
constexpr auto kRunAwayEnds = std::to_array<std::pair<RunAwayEnd, std::string_view>>(
    {{RunAwayEnd::none, ""},
     {RunAwayEnd::new_equilibrium, "new equilibrium"},
     {RunAwayEnd::end_of_travel, "end of travel"}});

}  // namespace

std::string_view to_string(Origin origin) {
  return origin == Origin::simulated ? "simulated" : "recorded";
}
std::string_view to_string(StageRole role) { return name_of<StageRole>(role, kRoles); }
std::string_view to_string(Drainage drainage) { return name_of<Drainage>(drainage, kDrainages); }
std::string_view to_string(AxialControl control) {
  return name_of<AxialControl>(control, kControls);
}
std::string_view to_string(RunAwayEnd end) { return name_of<RunAwayEnd>(end, kRunAwayEnds); }
std::optional<RunAwayEnd> run_away_end_from(std::string_view text) {
  return value_of<RunAwayEnd>(text, kRunAwayEnds);
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

bool RecordHeader::is_total_stress() const {
  const TestType* type = find_test_type(programme);
  return type != nullptr && type->is_total_stress();
}

bool RecordHeader::is_foreign() const {
  constexpr std::string_view kOwn = "triax";  // lab/records/dialects/triax.toml
  return !dialect.empty() && dialect != kOwn;
}

bool RecordHeader::is_unconfined() const {
  const TestType* type = find_test_type(programme);
  return type != nullptr && type->unconfined;
}

const StageInfo* RecordHeader::stage(int number) const {
  const auto found = std::ranges::find(stages, number, &StageInfo::number);
  return found == stages.end() ? nullptr : &*found;
}

}  // namespace triax::lab
