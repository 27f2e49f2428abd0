// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lab/base/names.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/programmes/programme.hpp"

namespace triax::lab {
namespace {

using Action = Guard::Action;

constexpr auto kGuardActions =
    std::to_array<std::pair<Action, std::string_view>>({{Action::hand_over, "hand_over"},
                                                        {Action::hold, "hold"},
                                                        {Action::unload, "unload"},
                                                        {Action::safe, "safe"}});

WarningLevel read_level(const TomlTable& table) {
  const std::string word = table.required_text("on");
  const auto level = warning_level_from(word);
  if (level && *level != WarningLevel::none) return *level;
  table.fail("on", invalid_value(word, {"approaching", "imminent", "lost"}));
}

Action read_action(const TomlTable& table) {
  const std::string word = table.required_text("action");
  if (const auto action = value_of<Action>(word, kGuardActions)) return *action;
  table.fail("action", invalid_value(word, {"hand_over", "hold", "unload", "safe"}));
}

/// A key that another action would not heed is a mistake.
void refuse_others(const TomlTable& table, const Guard& guard) {
  struct Of {
    const char* key;
    std::array<Action, 2> actions;
  };
  for (const auto& [key, actions] : {Of{"rate_mm_per_min", {Action::hand_over, Action::unload}},
                                     Of{"further_strain_pct", {Action::hand_over}},
                                     Of{"share", {Action::unload, Action::unload}},
                                     Of{"hold_min", {Action::hold, Action::unload}}})
    if (table.has(key) && std::ranges::find(actions, guard.action) == actions.end())
      table.fail(key, fmt::format("has no effect with action = \"{}\"; leave it out",
                                  to_string(guard.action)));
}

double read_guard_rate(const TomlTable& table, const LoadingFrame& frame) {
  const double rate = table.required_number("rate_mm_per_min", {.above = 0}) * 1e-3 / 60;
  if (!gives(frame, rate))
    table.fail("rate_mm_per_min",
               fmt::format("the frame gives {:g} to {:g} mm/min", frame.slowest_m_per_s * 6e4,
                           frame.fastest_m_per_s * 6e4));
  return rate;
}

}  // namespace

std::string_view to_string(Action action) { return name_of<Action>(action, kGuardActions); }

bool guards(const Guard& guard, const Stage& stage) {
  if (stage.role != StageRole::shear || stage.axial == AxialAction::free) return false;
  return guard.action != Action::hand_over || by_force(stage.axial) ||
         stage.axial == AxialAction::spring;
}

Guard read_guard(const TomlTable& table, const Programme& programme) {
  Guard guard;
  guard.on = read_level(table);
  guard.action = read_action(table);
  refuse_others(table, guard);
  if (guard.action == Action::hand_over || guard.action == Action::unload)
    guard.rate_m_per_s = read_guard_rate(table, programme.frame);
  const auto further = table.number("further_strain_pct", {.above = 0, .at_most = 30});
  guard.further_strain = further ? *further / 100 : guard.further_strain;
  guard.share = table.number("share", {.at_least = 0.01, .at_most = 1}).value_or(guard.share);
  const auto minutes = table.number("hold_min", {.above = 0, .at_most = 1e5});
  guard.hold_s = minutes ? *minutes * 60 : guard.hold_s;
  table.finish();
  if (std::ranges::none_of(programme.stages, [&](const Stage& s) { return guards(guard, s); }))
    table.fail(
        "action",
        guard.action == Action::hand_over
            ? "no shear stage is driven by load, dead_load, constant_q, stress_ratio or spring, so "
              "control cannot be switched to displacement; must be one of: hold, unload, safe"
            : "no stage is a shear stage with a piston; leave [guard] out");
  return guard;
}

}  // namespace triax::lab
