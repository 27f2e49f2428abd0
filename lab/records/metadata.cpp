// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/metadata.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/truth_toml.hpp"
#include "lab/results/labels.hpp"

namespace triax::lab {
namespace {

std::string full_name(std::string_view name, std::string_view unit) {
  return unit.empty() ? std::string(name) : fmt::format("{}_{}", name, unit);
}

double parse_number(const std::string& where, std::string_view key, std::string_view text) {
  const auto value = whole_text_as<double>(text);
  if (!value || !std::isfinite(*value))
    throw BadInput(
        fmt::format("{}: {} = {} is not a number (write it like 12.5)", where, key, excerpt(text)));
  return *value;
}

std::string names_of(std::initializer_list<std::string_view> names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

template <class Value>
Value one_of(const std::string& where, std::string_view key, std::string_view text,
             std::optional<Value> found, std::initializer_list<std::string_view> allowed) {
  if (found) return *found;
  throw BadInput(fmt::format("{}: {} = {} is not valid; must be one of: {}", where, key,
                             excerpt(text), names_of(allowed)));
}

[[noreturn]] void unknown_key(const std::string& where, std::string_view key) {
  throw BadInput(
      fmt::format("{}: unknown key {}; {}", where, excerpt(key), suggestion(key, metadata_keys())));
}

/// A number in the unit of the row or, at the end of `name`, another of its kind, as SI. Empty if
/// the name is not that of the row. Throws BadInput for no number and for one out of the row's
/// bounds.
std::optional<double> value_of(const NumberKey& row, const std::string& where, std::string_view key,
                               std::string_view name, std::string_view value) {
  auto unit = *sim::find_unit(row.unit);
  if (name != full_name(row.name, row.unit)) {
    const auto other = split_unit(name);
    if (!other || other->name != row.name || other->unit.dimension != unit.dimension)
      return std::nullopt;
    unit = other->unit;
  }
  const double number = parse_number(where, key, value);
  // Compared in the unit that was given, so that a bound itself always counts as inside.
  const auto bound = [&](double field) {
    return sim::to_field(sim::to_si(field, *sim::find_unit(row.unit)), unit);
  };
  if (!(number >= bound(row.lowest) && number <= bound(row.highest)))
    throw BadInput(fmt::format("{}: {} = {} is out of range; expected {:g} to {:g}{}{}", where, key,
                               number, bound(row.lowest), bound(row.highest),
                               unit.name.empty() ? "" : " ", unit.name));
  return sim::to_si(number, unit);
}

constexpr NumberKey kCellPressure{"cell_pressure", "kPa", 0, 1e6};

void set_test(RecordHeader& header, const std::string& where, std::string_view key,
              std::string_view name, std::string_view value) {
  if (name == "name") {
    if (trimmed(value).empty()) throw BadInput(where + ": test.name is empty");
    header.name = value;
  } else if (name == "programme") {
    header.programme = value;
  } else if (name == "origin") {
    std::optional<Origin> origin;
    if (value == "recorded") origin = Origin::recorded;
    if (value == "simulated") origin = Origin::simulated;
    header.origin = one_of(where, key, value, origin, {"recorded", "simulated"});
  } else if (name == "cut_short") {
    header.cut_short = value;
  } else if (name == "seed") {
    const auto seed = whole_text_as<std::uint64_t>(value);
    if (!seed || *seed > kMaxSeed)
      throw BadInput(fmt::format("{}: {} = {} is not an integer from 0 to {}", where, key,
                                 excerpt(value), kMaxSeed));
    header.seed = seed;
  } else if (const auto held = value_of(kCellPressure, where, key, name, value)) {
    header.cell_pressure_pa = held;
  } else {
    unknown_key(where, key);
  }
}

void set_specimen(SpecimenInfo& specimen, const std::string& where, std::string_view key,
                  std::string_view name, std::string_view value) {
  if (name == "material") {
    specimen.material = value;
    return;
  }
  for (const SpecimenKey& row : specimen_keys())
    if (const auto number = value_of(row, where, key, name, value)) {
      specimen.*row.member = number;
      return;
    }
  unknown_key(where, key);
}

StageInfo& stage_of(RecordHeader& header, int number) {
  const auto found = std::ranges::find(header.stages, number, &StageInfo::number);
  if (found != header.stages.end()) return *found;
  StageInfo made;
  made.number = number;
  return header.stages.emplace_back(made);
}

void set_stage(StageInfo& stage, const std::string& where, std::string_view key,
               std::string_view name, std::string_view value) {
  if (name == "name")
    stage.name = value;
  else if (name == "role")
    stage.role = one_of(where, key, value, stage_role_from(value),
                        {"saturation", "b_check", "consolidation", "shear", "hold", "unknown"});
  else if (name == "drainage")
    stage.drainage = one_of(where, key, value, drainage_from(value), {"open", "closed", "unknown"});
  else if (name == "control")
    stage.control = one_of(where, key, value, axial_control_from(value),
                           {"displacement", "load", "constant_q", "unknown"});
  else if (name == "strain_path_R")
    stage.strain_path_R = parse_number(where, key, value);
  else
    unknown_key(where, key);
}

void set_sensor(RecordHeader& header, const std::string& where, std::string_view key,
                std::string_view name, std::string_view value) {
  const auto channel = find_quantity(name);
  if (!channel) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < kQuantityCount; ++i)
      names.emplace_back(info(static_cast<Quantity>(i)).name);
    throw BadInput(
        fmt::format("{}: no channel {}; {}", where, excerpt(name), suggestion(name, names)));
  }
  if (value != "sound")
    throw BadInput(
        fmt::format("{}: {} = {} is not valid; expected sound", where, key, excerpt(value)));
  if (std::ranges::find(header.vouched, *channel) == header.vouched.end())
    header.vouched.push_back(*channel);
}

void set_label_of(RecordHeader& header, const std::string& where, std::string_view key,
                  std::string_view name, std::string_view value) {
  const LabelKey* const label = find_label(name);
  if (label == nullptr) unknown_key(where, key);
  if (!is_utf8(value) || std::ranges::any_of(value, [](unsigned char c) { return c < ' '; }))
    throw BadInput(
        fmt::format("{}: {} = {} must be one line of UTF-8 text", where, key, excerpt(value)));
  set_label(header, *label, value);
}

/// The N and the rest of "stages.N.role".
std::optional<std::pair<int, std::string_view>> split_stage_key(std::string_view rest) {
  const auto dot = rest.find('.');
  const auto number = whole_text_as<int>(rest.substr(0, dot));
  if (dot == std::string_view::npos || !number || *number < 0) return std::nullopt;
  return std::pair(*number, rest.substr(dot + 1));
}

std::string stage_text(const StageInfo& stage, std::string_view name) {
  if (name == "name") return stage.name;
  if (name == "role") return std::string(to_string(stage.role));
  if (name == "drainage") return std::string(to_string(stage.drainage));
  if (name == "control") return std::string(to_string(stage.control));
  return stage.strain_path_R ? fmt::format("{}", *stage.strain_path_R) : std::string();
}

/// The row of a key with any unit of its dimension.
const SpecimenKey* find_specimen_key(std::string_view name) {
  for (const SpecimenKey& row : specimen_keys()) {
    if (name == full_name(row.name, row.unit)) return &row;
    const auto other = split_unit(name);
    if (other && other->name == row.name &&
        other->unit.dimension == sim::find_unit(row.unit)->dimension)
      return &row;
  }
  return nullptr;
}

void append_number(std::string& out, std::string_view name, std::string_view unit,
                   const std::optional<double>& si) {
  if (!si || !std::isfinite(*si)) return;
  const auto text = fmt::format("{}", sim::to_field(*si, *sim::find_unit(unit)));
  out += fmt::format("{} = {}\n", full_name(name, unit), text);
}

void append_text(std::string& out, std::string_view name, std::string_view text) {
  if (!text.empty()) out += fmt::format("{} = {}\n", name, toml_quoted(text));
}

}  // namespace

std::optional<NamedUnit> split_unit(std::string_view name) {
  const auto at = name.rfind('_');
  if (at == std::string_view::npos || at == 0 || at + 1 == name.size()) return std::nullopt;
  const auto unit = sim::find_unit(name.substr(at + 1));
  if (!unit) return std::nullopt;
  return NamedUnit{name.substr(0, at), *unit};
}

const std::vector<SpecimenKey>& specimen_keys() {
  static const std::vector<SpecimenKey> keys{
      {{"height", "mm", 5, 3000}, &SpecimenInfo::height_m},
      {{"diameter", "mm", 5, 3000}, &SpecimenInfo::diameter_m},
      {{"void_ratio", "", 0.05, 20}, &SpecimenInfo::void_ratio},
      {{"consolidated_void_ratio", "", 0.05, 20}, &SpecimenInfo::consolidated_void_ratio},
      {{"consolidated_height", "mm", 5, 3000}, &SpecimenInfo::consolidated_height_m},
      {{"dry_mass", "g", 0.1, 1e8}, &SpecimenInfo::dry_mass_kg},
      {{"specific_gravity", "", 1, 10}, &SpecimenInfo::specific_gravity},
      {{"membrane_thickness", "mm", 1e-3, 10}, &SpecimenInfo::membrane_thickness_m},
      {{"membrane_modulus", "kPa", 1, 1e7}, &SpecimenInfo::membrane_modulus_pa},
      {{"limit_friction_angle", "deg", 1, 89}, &SpecimenInfo::limit_friction_angle_rad},
      {{"cohesion", "kPa", 0, 1e6}, &SpecimenInfo::cohesion_pa}};
  return keys;
}

std::vector<std::string> metadata_keys() {
  std::vector<std::string> keys{"test.name", "test.origin",    "test.programme",
                                "test.seed", "test.cut_short", "test.cell_pressure_kPa"};
  for (const SpecimenKey& row : specimen_keys())
    keys.push_back("specimen." + full_name(row.name, row.unit));
  for (const char* key :
       {"specimen.material", "stages.N.name", "stages.N.role", "stages.N.drainage",
        "stages.N.control", "stages.N.strain_path_R", "sensors.CHANNEL"})
    keys.emplace_back(key);
  for (const LabelKey& label : label_keys()) keys.push_back("labels." + std::string(label.key));
  return keys;
}

void set_metadata(RecordHeader& header, const std::string& where, std::string_view key,
                  std::string_view value) {
  const auto dot = key.find('.');
  const auto group = key.substr(0, dot);
  const auto rest = dot == std::string_view::npos ? std::string_view() : key.substr(dot + 1);
  if (group == "test") {
    set_test(header, where, key, rest, value);
  } else if (group == "specimen") {
    set_specimen(header.specimen, where, key, rest, value);
  } else if (group == "sensors") {
    set_sensor(header, where, key, rest, value);
  } else if (group == "labels") {
    set_label_of(header, where, key, rest, value);
  } else if (group == "stages") {
    const auto split = split_stage_key(rest);
    if (!split) unknown_key(where, key);
    // A copy first: a bad value leaves no stage behind.
    StageInfo probe;
    set_stage(probe, where, key, split->second, value);
    set_stage(stage_of(header, split->first), where, key, split->second, value);
  } else {
    unknown_key(where, key);
  }
}

std::string canonical_key(std::string_view key) {
  const auto dot = key.find('.');
  const auto group = key.substr(0, dot);
  const auto rest = dot == std::string_view::npos ? std::string_view() : key.substr(dot + 1);
  if (group == "specimen")
    if (const SpecimenKey* const row = find_specimen_key(rest))
      return "specimen." + full_name(row->name, row->unit);
  if (group == "labels")
    if (const LabelKey* const label = find_label(rest)) return "labels." + std::string(label->key);
  if (group == "stages")
    if (const auto split = split_stage_key(rest))
      return fmt::format("stages.{}.{}", split->first, split->second);
  return std::string(key);
}

std::string metadata_text(const RecordHeader& header, std::string_view key) {
  const auto dot = key.find('.');
  const auto group = key.substr(0, dot);
  const auto rest = dot == std::string_view::npos ? std::string_view() : key.substr(dot + 1);
  if (key == "test.name") return header.name;
  if (key == "test.programme") return header.programme;
  if (key == "test.cut_short") return header.cut_short;
  if (key == "specimen.material") return header.specimen.material;
  if (group == "specimen") {
    const SpecimenKey* const row = find_specimen_key(rest);
    const auto si = row ? header.specimen.*row->member : std::nullopt;
    return si ? fmt::format("{:.15g}", sim::to_field(*si, *sim::find_unit(row->unit))) : "";
  }
  if (group == "labels") {
    const LabelKey* const label = find_label(rest);
    return label ? label_text(header, *label) : "";
  }
  if (group == "sensors") {
    const auto channel = find_quantity(rest);
    const bool sound =
        channel && std::ranges::find(header.vouched, *channel) != header.vouched.end();
    return sound ? "sound" : "";
  }
  const auto split = split_stage_key(rest);
  const StageInfo* const stage = group == "stages" && split ? header.stage(split->first) : nullptr;
  return stage ? stage_text(*stage, split->second) : std::string();
}

void read_metadata(RecordHeader& header, std::optional<Truth>& truth, const TomlTable& document) {
  const auto take = [&](const TomlTable& table, const std::string& prefix) {
    for (const auto& key : table.keys()) {
      const auto where = fmt::format("{}:{}", table.file(), table.line(key));
      set_metadata(header, where, prefix + key, table.scalar(key).value_or(""));
    }
  };
  if (const auto table = document.table("test")) take(*table, "test.");
  if (const auto table = document.table("specimen")) take(*table, "specimen.");
  if (const auto table = document.table("sensors")) take(*table, "sensors.");
  if (const auto table = document.table("labels")) take(*table, "labels.");
  std::vector<std::int64_t> described;
  for (const TomlTable& table : document.tables("stages")) {
    const auto number = table.integer("number");
    if (!number || *number < 0 || *number > 1'000'000)
      throw BadInput(table.file(), table.line(), "[[stages]] needs number = 1, 2, ...");
    if (std::ranges::find(described, *number) != described.end())
      table.fail("number", fmt::format("stage {} is described twice; keep one", *number));
    described.push_back(*number);
    const auto prefix = fmt::format("stages.{}.", *number);
    stage_of(header, static_cast<int>(*number));
    for (const auto& key : table.keys()) {
      if (key == "number") continue;
      const auto where = fmt::format("{}:{}", table.file(), table.line(key));
      set_metadata(header, where, prefix + key, table.scalar(key).value_or(""));
    }
  }
  if (const auto table = document.table("truth")) truth = read_truth(*table);
  document.finish();
}

std::string ending_toml(const RecordHeader& header) {
  if (header.cut_short.empty()) return {};
  std::string out = "[test]\n";
  append_text(out, "cut_short", header.cut_short);
  return out;
}

std::string metadata_toml(const RecordHeader& header) {
  std::string out = "[test]\n";
  append_text(out, "name", header.name);
  append_text(out, "origin", to_string(header.origin));
  append_text(out, "programme", header.programme);
  if (header.seed) out += fmt::format("seed = {}\n", *header.seed);
  append_number(out, kCellPressure.name, kCellPressure.unit, header.cell_pressure_pa);
  out += "[specimen]\n";
  append_text(out, "material", header.specimen.material);
  for (const SpecimenKey& row : specimen_keys())
    append_number(out, row.name, row.unit, header.specimen.*row.member);
  if (!header.vouched.empty()) out += "[sensors]\n";
  for (const Quantity channel : header.vouched) append_text(out, info(channel).name, "sound");
  for (const StageInfo& stage : header.stages) {
    out += fmt::format("[[stages]]\nnumber = {}\n", stage.number);
    append_text(out, "name", stage.name);
    append_text(out, "role", to_string(stage.role));
    append_text(out, "drainage", to_string(stage.drainage));
    append_text(out, "control", to_string(stage.control));
    append_number(out, "strain_path_R", "", stage.strain_path_R);
  }
  return out;
}

std::string as_comment(std::string_view toml) {
  std::string out;
  while (!toml.empty()) {
    const auto end = toml.find('\n');
    out.append("# ").append(toml.substr(0, end)).append("\n");
    toml.remove_prefix(end == std::string_view::npos ? toml.size() : end + 1);
  }
  return out;
}

}  // namespace triax::lab
