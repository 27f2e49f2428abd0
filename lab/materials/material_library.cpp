// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/materials/material_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/embedded.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/materials/search_ranges.hpp"

namespace triax::lab {
namespace {

/// A law that is built on another material finds it among these.
sim::MaterialFinder finder_in(const std::vector<MaterialSet>& sets) {
  return [&sets](const std::string& name) { return find_material(name, sets).material; };
}

std::optional<ValidRange> read_range(const TomlTable& table, const char* key) {
  const auto ends = table.numbers(key);
  if (ends.empty()) return std::nullopt;
  if (ends.size() != 2 || !(ends[0] < ends[1]) || ends[0] < 0)
    table.fail(key, "must be two numbers of 0 or more, [lowest, highest]");
  return ValidRange{ends[0], ends[1]};
}

/// In so many digits that one sees that it is not within.
std::string digits_outside(const ValidRange& range, double value) {
  for (int digits = 4; digits < 10; ++digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    if (!range.holds(whole_text_as<double>(text).value_or(value))) return text;
  }
  return fmt::format("{}", value);
}

std::optional<std::string> outside(const MaterialSet& set, const std::optional<ValidRange>& range,
                                   const char* name, double value, const char* unit) {
  if (!range || range->holds(value)) return std::nullopt;
  const std::string from = range->low > 0 ? fmt::format("{:g} to", range->low) : "up to";
  return fmt::format("{} is {}{}, outside the range {} {:g}{} of {}", name,
                     digits_outside(*range, value), unit, from, range->high, unit, set.name);
}

MaterialSet read_set(const TomlTable& table, const sim::LawDescription& law,
                     const std::string& name, const std::string& folder,
                     const std::vector<MaterialSet>& others) {
  MaterialSet set;
  set.name = fmt::format("{}/{}", law.name, name);
  set.law = &law;
  set.description = table.text("description").value_or("");
  set.source = table.text("source").value_or("");
  set.range = table.text("range").value_or("");
  set.void_ratio_range = read_range(table, "void_ratio_range");
  set.p_eff_range_kPa = read_range(table, "p_eff_range_kPa");
  set.parameters.folder = folder;
  for (const auto& parameter : law.parameters) {
    const std::string& key = parameter.key;
    if (parameter.kind == sim::ParameterKind::number) {
      if (const auto value = table.number(key)) set.parameters.numbers[key] = *value;
    } else if (parameter.kind == sim::ParameterKind::text) {
      if (const auto value = table.text(key)) set.parameters.texts[key] = *value;
    } else if (const auto values = table.numbers(key); !values.empty()) {
      set.parameters.lists[key] = values;
    }
  }
  table.finish();
  try {
    set.material = set.law->make(set.parameters, finder_in(others));
  } catch (const std::invalid_argument& error) {
    table.fail("", fmt::format("the set {}: {}", set.name, error.what()));
  }
  return set;
}

const sim::LawDescription& read_law(const TomlTable& root) {
  const std::string name = root.required_text("law");
  if (const auto* law = sim::find_law(name)) return *law;
  std::vector<std::string> known;
  for (const auto& law : sim::laws()) known.push_back(law.name);
  root.fail("law", fmt::format("unknown law {}; {}", excerpt(name), suggestion(name, known)));
}

std::vector<MaterialSet> read_file(std::string_view toml_text, const std::string& file,
                                   const std::vector<MaterialSet>& others) {
  const TomlTable root = TomlTable::parse(toml_text, file);
  const sim::LawDescription& law = read_law(root);
  const TomlTable sets = root.required_table("sets");
  read_search(root);  // which makes its keys known ones
  root.finish();
  const std::string folder = std::filesystem::path(file).parent_path().string();
  std::vector<MaterialSet> found;
  for (const std::string& key : sets.keys())
    found.push_back(read_set(sets.required_table(key), law, key, folder, others));
  if (found.empty()) throw BadInput(file, 0, "no parameter set found; write [sets.NAME]");
  return found;
}

/// In the order of the laws: one that stands on another comes after it.
std::vector<MaterialSet> read_shipped() {
  std::vector<MaterialSet> all;
  for (const auto& law : sim::laws())
    for (const EmbeddedFile& file : kShippedMaterials) {
      if (file.name != law.name) continue;
      auto sets = read_file(file.text, std::string(file.name) + ".toml", all);
      std::ranges::move(sets, std::back_inserter(all));
    }
  return all;
}

}  // namespace

bool ValidRange::holds(double value) const {
  constexpr double kRoundOff = 1e-9;
  return value >= low * (1 - kRoundOff) && value <= high * (1 + kRoundOff);
}

std::optional<std::string> void_ratio_outside(const MaterialSet& set, double void_ratio) {
  return outside(set, set.void_ratio_range, "void ratio", void_ratio, "");
}

std::optional<std::string> p_eff_outside(const MaterialSet& set, double p_eff_pa) {
  return outside(set, set.p_eff_range_kPa, "p'", p_eff_pa / 1e3, " kPa");
}

std::vector<MaterialSet> read_materials(std::string_view toml_text, const std::string& file) {
  return read_file(toml_text, file, shipped_materials());
}

const std::vector<MaterialSet>& shipped_materials() {
  static const std::vector<MaterialSet> all = read_shipped();
  return all;
}

MaterialSet find_material(std::string_view name, const std::vector<MaterialSet>& sets) {
  std::vector<std::string> names;
  for (const MaterialSet& set : sets) {
    if (set.name == name) return set;
    names.push_back(set.name);
  }
  throw BadInput(fmt::format("unknown material {}; {}", excerpt(name), suggestion(name, names)));
}

MaterialSet find_material(std::string_view name) {
  return find_material(name, shipped_materials());
}

sim::Material made_anew(const MaterialSet& set) {
  return set.law->make(set.parameters, finder_in(shipped_materials()));
}

MaterialSet with_parameter(const MaterialSet& set, const std::string& key,
                           const std::string& value) {
  std::vector<std::string> known;
  const sim::ParameterDescription* found = nullptr;
  for (const auto& parameter : set.law->parameters) {
    known.push_back(parameter.key);
    if (parameter.key == key) found = &parameter;
  }
  if (found == nullptr)
    throw BadInput(fmt::format("{}: unknown parameter {}; {}", set.name, excerpt(key),
                               suggestion(key, known)));
  MaterialSet changed = set;
  if (found->kind == sim::ParameterKind::text) {
    changed.parameters.texts[key] = value;
    if (found->chooses) {  // what the set held belongs to the old value, and so does its range
      changed.parameters.numbers.clear();
      changed.parameters.lists.clear();
      changed.description = changed.range = "";
      changed.void_ratio_range = changed.p_eff_range_kPa = std::nullopt;
      changed.source = key + " changed for this run, not calibrated";
    }
  } else {
    const auto number = whole_text_as<double>(value);
    if (!number || found->kind != sim::ParameterKind::number)
      throw BadInput(fmt::format("{}={}: expected one number", key, excerpt(value)));
    changed.parameters.numbers[key] = *number;
  }
  changed.name += fmt::format(" ({} = {})", key, value);
  try {
    changed.material = changed.law->make(changed.parameters, finder_in(shipped_materials()));
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("{}: {}", set.name, error.what()));
  }
  return changed;
}

}  // namespace triax::lab
