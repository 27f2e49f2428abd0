// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_stage_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "lab/base/bounds.hpp"
#include "lab/base/text.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {
namespace {

using Quantity = sim::PathMark::Quantity;

constexpr Bounds kPressure{.above = 0, .at_most = kLargestPressure_kPa};
constexpr Bounds kPositive{.above = 0, .at_most = 1};
constexpr Bounds kRatio{.at_least = 0.05, .at_most = 20};
constexpr std::int64_t kMostSteps = 1000000000;

struct MarkQuantity {
  std::string_view word;
  Quantity quantity;
  double scale;
};
constexpr auto kMarkQuantities =
    std::to_array<MarkQuantity>({{"stress_ratio", Quantity::stress_ratio, 1},
                                 {"path_stress_kPa", Quantity::path_stress_pa, 1e3},
                                 {"axial_strain_pct", Quantity::axial_strain, 1e-2}});

/// Sets `value` where the key is there, times `scale`.
void take(const TomlTable& table, std::string_view key, const Bounds& bounds, double scale,
          double& value) {
  if (const auto given = table.number(key, bounds)) value = scale * *given;
}
void take(const TomlTable& table, std::string_view key, std::int64_t lowest, std::int64_t highest,
          std::int64_t& value) {
  value = table.integer(key, lowest, highest).value_or(value);
}

void read_mark(const TomlTable& table, GrainPathStage& stage) {
  const std::string word = table.required_text("quantity");
  std::vector<std::string> known;
  const MarkQuantity* found = nullptr;
  for (const MarkQuantity& candidate : kMarkQuantities) {
    known.emplace_back(candidate.word);
    if (candidate.word == word) found = &candidate;
  }
  if (found == nullptr) table.fail("quantity", invalid_value(word, known));
  sim::PathMark mark;
  mark.quantity = found->quantity;
  mark.value = found->scale * table.required_number("value");
  mark.falling = table.flag("falling").value_or(false);
  stage.mark_names.push_back(table.required_text("name"));
  table.finish();
  stage.path.marks.push_back(mark);
}

void read_course(const TomlTable& table, GrainPathStage& stage) {
  sim::GrainPath& path = stage.path;
  const auto strain = table.number("strain_rate_per_s", {.at_least = -100, .at_most = 100});
  const auto load = table.number("load_rate_kPa_per_s", {.at_least = -1e9, .at_most = 1e9});
  const char* key = load ? "load_rate_kPa_per_s" : "strain_rate_per_s";
  if (strain.has_value() == load.has_value())
    table.fail(strain ? key : "", "give either strain_rate_per_s or load_rate_kPa_per_s");
  if (strain.value_or(0) == 0 && load.value_or(0) == 0) table.fail(key, "must not be 0");
  path.strain_rate_per_s = strain.value_or(0);
  path.load_rate_pa_per_s = 1e3 * load.value_or(0);
  path.axial_strain =
      1e-2 * table.required_number("end_axial_strain_pct", {.above = 0, .at_most = 90});
  path.stress_ratio = table.number("end_stress_ratio", {.at_least = -1.5, .at_most = 3});
  take(table, "collapse_share", {.at_least = 0, .at_most = 0.99}, 1, path.collapse_share);
  for (const TomlTable& mark : table.tables("marks")) read_mark(mark, stage);
}

GrainPathStage read_path(const TomlTable& table, const std::string& action) {
  GrainPathStage stage;
  sim::GrainPath& path = stage.path;
  path.samples = static_cast<int>(table.integer("samples", 2, 100000).value_or(400));
  stage.snapshots = static_cast<int>(table.integer("snapshots", 0, 10000).value_or(0));
  stage.lammps = table.flag("lammps").value_or(false);
  take(table, "most_steps", 1, kMostSteps, path.most_steps);
  if (action == "isotropic") {
    path.kind = sim::GrainPathKind::isotropic;
    path.pressure_pa = 1e3 * table.required_number("pressure_kPa", kPressure);
    take(table, "stress_rate_kPa_per_s", {.at_least = 0, .at_most = 1e9}, 1e3,
         path.stress_rate_pa_per_s);
    take(table, "unbalanced", kPositive, 1, path.unbalanced);
    take(table, "pressure_share", kPositive, 1, path.pressure_share);
    return stage;
  }
  path.kind = sim::GrainPathKind::strain_path;
  if (action == "drained") {
    path.kind = sim::GrainPathKind::drained;
    path.pressure_pa = 1e3 * table.required_number("radial_stress_kPa", kPressure);
  } else if (action == "strain_path") {
    path.ratio = table.required_number("strain_path_R", kRatio);
  }
  read_course(table, stage);
  if (stage.lammps && path.load_rate_pa_per_s != 0)
    table.fail("lammps", "a path by load cannot be written for LAMMPS; give strain_rate_per_s");
  return stage;
}

void read_settling(const TomlTable& table, sim::Settling& settling) {
  take(table, "unbalanced", kPositive, 1, settling.unbalanced);
  take(table, "stress_error_Pa", {.above = 0, .at_most = 1e7}, 1, settling.stress_error_pa);
  take(table, "most_steps", 1, kMostSteps, settling.most_steps);
}

GrainRestStage read_rest(const TomlTable& table, const std::string& action) {
  GrainRestStage stage;
  stage.strain_held = action == "equilibrium";
  take(table, "strain_path_R", kRatio, 1, stage.ratio);
  if (!stage.strain_held) {
    if (const auto axial = table.number("axial_stress_kPa", kPressure))
      stage.axial_stress_pa = 1e3 * *axial;
    if (const auto radial = table.number("radial_stress_kPa", kPressure))
      stage.radial_stress_pa = 1e3 * *radial;
  }
  read_settling(table, stage.settling);
  return stage;
}

GrainProbeStage read_probes(const TomlTable& table) {
  GrainProbeStage stage;
  sim::GrainProbing& how = stage.probing;
  stage.directions = static_cast<int>(table.integer("directions", 1, 3600).value_or(36));
  const auto stress = table.number("norm_kPa", {.above = 0, .at_most = 1e4});
  const auto strain = table.number("norm_strain", {.above = 0, .at_most = 0.01});
  if (stress && strain)
    table.fail("norm_strain",
               "give either norm_kPa (stress probes) or norm_strain (strain probes)");
  if (stress) how.norm_pa = 1e3 * *stress;
  if (strain) {
    how.kind = sim::ProbeKind::strain;
    how.norm_strain = *strain;
  }
  take(table, "ramp_steps", 2, kMostSteps, how.ramp_steps);
  take(table, "unbalanced", kPositive, 1, how.unbalanced);
  take(table, "stress_error_Pa", {.above = 0, .at_most = 1e7}, 1, how.stress_error_pa);
  take(table, "most_steps", 1, kMostSteps, how.most_steps);
  if (how.most_steps <= how.ramp_steps)
    table.fail("most_steps", fmt::format("must be above the {} steps of the ramp", how.ramp_steps));
  return stage;
}

GrainPerturbationStage read_perturbation(const TomlTable& table) {
  GrainPerturbationStage stage;
  sim::Perturbation& how = stage.perturbation;
  how.ratio = table.required_number("strain_path_R", kRatio);
  const auto load = table.number("load_step_Pa", {.at_least = -1e7, .at_most = 1e7});
  const auto energy = table.number("kinetic_energy_J", {.at_least = 0, .at_most = 1e3});
  if (!load && !energy) table.fail("", "expected load_step_Pa, kinetic_energy_J or both, above 0");
  how.load_step_pa = load.value_or(0);
  how.kinetic_energy_j = energy.value_or(0);
  take(table, "floating_share", kPositive, 1, how.floating_share);
  how.seed = static_cast<std::uint64_t>(table.integer("seed", 0).value_or(1));
  take(table, "unbalanced", kPositive, 1, how.unbalanced);
  take(table, "stress_error_Pa", {.above = 0, .at_most = 1e7}, 1, how.stress_error_pa);
  if (how.load_step_pa != 0 && how.stress_error_pa >= 0.5 * std::abs(how.load_step_pa))
    table.fail(
        "stress_error_Pa",
        fmt::format("{:g} Pa is out of range; expected less than half of the step of {:g} Pa",
                    how.stress_error_pa, how.load_step_pa));
  take(table, "longest_s", {.above = 0, .at_most = 1e4}, 1, how.longest_s);
  take(table, "collapse_share", {.at_least = 0, .at_most = 0.99}, 1, how.collapse_share);
  take(table, "collapse_strain_pct", {.above = 0, .at_most = 90}, 1e-2, how.collapse_strain);
  return stage;
}

}  // namespace

std::vector<std::string> grain_actions() {
  return {"isotropic", "drained",     "undrained", "strain_path",
          "rest",      "equilibrium", "probes",    "perturbation"};
}

GrainStage read_grain_stage(const TomlTable& table) {
  GrainStage stage;
  stage.line = table.line();
  stage.name = table.required_text("name");
  stage.action = table.required_text("action");
  stage.from = table.text("from").value_or("");
  stage.save = table.flag("save").value_or(false);
  const std::string& action = stage.action;
  if (action == "rest" || action == "equilibrium")
    stage.work = read_rest(table, action);
  else if (action == "probes")
    stage.work = read_probes(table);
  else if (action == "perturbation")
    stage.work = read_perturbation(table);
  else if (action == "isotropic" || action == "drained" || action == "undrained" ||
           action == "strain_path")
    stage.work = read_path(table, action);
  else
    table.fail("action", invalid_value(action, grain_actions()));
  table.finish();
  return stage;
}

}  // namespace triax::lab
