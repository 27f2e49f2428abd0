// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_programme_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/bounds.hpp"
#include "lab/base/text.hpp"
#include "lab/grains/grain_stage_reader.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {
namespace {

constexpr Bounds kFriction{.at_least = 0, .at_most = 89};

sim::GradingCurve read_grading(const TomlTable& table) {
  sim::GradingCurve curve;
  for (const double size : table.numbers("diameter_mm")) {
    if (!Bounds{.at_least = 0.01, .at_most = 1000}.hold(size))
      table.fail(
          "diameter_mm",
          fmt::format("{:g} mm is out of range; expected a grain size from 0.01 to 1000", size));
    curve.diameter_m.push_back(1e-3 * size);
  }
  for (const double share : table.numbers("share_pct")) curve.share.push_back(1e-2 * share);
  if (!curve.share.empty() && curve.share.back() != 1)
    table.fail("share_pct", fmt::format("ends at {:g} %; expected 100", 100 * curve.share.back()));
  table.finish();
  try {
    check(curve);
  } catch (const std::invalid_argument& error) {
    table.fail("", error.what());
  }
  return curve;
}

void read_density(const TomlTable& table, GrainSource& source) {
  const auto friction = table.number("compaction_friction_deg", kFriction);
  const auto porosity = table.number("porosity", {.at_least = 0.2, .at_most = 0.7});
  if (friction.has_value() == porosity.has_value())
    table.fail(porosity ? "porosity" : "", "give either compaction_friction_deg or porosity");
  if (friction) {
    source.compaction.friction_angle = sim::radians(*friction);
    return;
  }
  sim::PorositySearch search;
  search.porosity = *porosity;
  search.tolerance =
      table.number("porosity_tolerance", {.at_least = 1e-5, .at_most = 0.1}).value_or(1e-3);
  search.most_trials = static_cast<int>(table.integer("most_trials", 1, 100).value_or(10));
  source.search = search;
}

void read_source(const TomlTable& table, GrainProgramme& programme) {
  GrainSource& source = programme.grains;
  const auto beside = [&](const std::string& name) {
    programme.files.push_back(
        (std::filesystem::path(programme.source).parent_path() / name).lexically_normal());
    return programme.files.back();
  };
  if (const auto state = table.text("state")) {
    source.state_file = beside(*state);
    return table.finish();
  }
  if (const auto packing = table.text("packing")) {
    source.packing_file = beside(*packing);
    const std::string axis = table.text("packing_axis").value_or("z");
    if (axis != "x" && axis != "y" && axis != "z")
      table.fail("packing_axis", fmt::format("{} is not valid; expected x, y or z", excerpt(axis)));
    source.packing_axis = axis[0] - 'x';
    return table.finish();
  }
  source.grains = static_cast<int>(table.integer("grains", 8, kMostGrains).value_or(10000));
  source.seed = static_cast<std::uint64_t>(table.integer("seed", 0).value_or(1));
  if (const auto grading = table.table("grading")) source.grading = read_grading(*grading);
  sim::Compaction& how = source.compaction;
  how.pressure_pa =
      1e3 * table.required_number("pressure_kPa", {.above = 0, .at_most = kLargestPressure_kPa});
  read_density(table, source);
  how.wall_speed_m_per_s =
      table.number("wall_speed_m_per_s", {.above = 0, .at_most = 10}).value_or(0.2);
  how.unbalanced = table.number("unbalanced", {.above = 0, .at_most = 1}).value_or(1e-3);
  how.most_steps = table.integer("most_steps", 1, 1000000000).value_or(how.most_steps);
  table.finish();
}

sim::ContactLaw read_law(const TomlTable& table) {
  sim::ContactLaw law;
  const std::string reading = table.text("stiffness_reading").value_or("in_series");
  if (reading == "literal")
    law.reading = sim::StiffnessReading::literal;
  else if (reading != "in_series")
    table.fail("stiffness_reading", invalid_value(reading, {"in_series", "literal"}));
  const auto number = [&](std::string_view key, const Bounds& bounds, double otherwise) {
    return table.number(key, bounds).value_or(otherwise);
  };
  law.stiffness_over_diameter_pa =
      1e6 * number("stiffness_over_diameter_MPa", {.above = 0, .at_most = 1e7}, 356);
  law.tangential_ratio = number("tangential_ratio", {.at_least = 0, .at_most = 10}, 0.42);
  law.friction_angle = sim::radians(number("friction_angle_deg", kFriction, 35));
  law.density_kg_per_m3 = number("density_kg_per_m3", {.at_least = 1, .at_most = 1e12}, 3000);
  law.damping = number("damping", {.at_least = 0, .at_most = 0.99}, 0.2);
  table.finish();
  return law;
}

/// Names that a later stage may start from, and that no other may have.
class Names {
 public:
  void take(const TomlTable& table, const std::string& name) {
    if (name == kAsMade)
      table.fail("name",
                 fmt::format("'{}' is reserved for the specimen before the first stage", kAsMade));
    const auto [at, is_new] = files_.emplace(in_file_name(name), name);
    if (!is_new)
      table.fail("name", fmt::format("{} and {} lead to the same file names", excerpt(name),
                                     excerpt(at->second)));
    known_.push_back(name);
  }
  void resolve(const TomlTable& table, GrainStage& stage, const std::string& before) const {
    if (stage.from.empty()) stage.from = before;
    if (stage.from == kAsMade ||
        std::find(known_.begin(), known_.end(), stage.from) != known_.end())
      return;
    table.fail("from", fmt::format("{} is not a stage or mark before this one; {}",
                                   excerpt(stage.from), suggestion(stage.from, with_start())));
  }

 private:
  std::vector<std::string> with_start() const {
    std::vector<std::string> all = known_;
    all.emplace_back(kAsMade);
    return all;
  }
  std::map<std::string, std::string> files_;
  std::vector<std::string> known_;
};

void read_stages(const TomlTable& root, GrainProgramme& programme) {
  Names names;
  std::string before = kAsMade;
  for (const TomlTable& table : root.tables("stages")) {
    GrainStage stage = read_grain_stage(table);
    names.resolve(table, stage, before);
    names.take(table, stage.name);
    if (const auto* path = std::get_if<GrainPathStage>(&stage.work))
      for (const std::string& mark : path->mark_names) names.take(table, mark);
    before = stage.name;
    programme.stages.push_back(std::move(stage));
  }
}

}  // namespace

GrainProgramme read_grain_programme(std::string_view toml_text, const std::string& file,
                                    const std::vector<TomlEdit>& edits) {
  const TomlTable root = TomlTable::parse(toml_text, file, 1, edits);
  GrainProgramme programme;
  programme.source = file;
  programme.files = {file};
  programme.text = toml_text;
  for (const TomlEdit& edit : edits) programme.settings += edit.key + "=" + edit.value + "\n";
  const TomlTable run = root.required_table("run");
  programme.name = run.required_text("name");
  run.finish();
  read_source(root.required_table("specimen"), programme);
  if (const auto law = root.table("contact")) {
    if (!programme.grains.state_file.empty())
      root.fail("contact", "the state in [specimen] contains its contact law; leave this out");
    programme.law = read_law(*law);
  }
  read_stages(root, programme);
  root.finish();
  return programme;
}

GrainProgramme load_grain_programme(const std::string& path, const std::vector<TomlEdit>& edits) {
  return read_grain_programme(read_text_file(path), path, edits);
}

}  // namespace triax::lab
