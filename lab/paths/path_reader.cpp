// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/bounds.hpp"
#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/paths/condition_text.hpp"
#include "lab/paths/path_quantity.hpp"
#include "lab/paths/path_table.hpp"

namespace triax::lab {
namespace {

constexpr int kPartsOfTableRow = 4;

const std::vector<std::string> kFrames = {"triaxial", "axisymmetric", "rendulic", "cartesian"};

std::string beside(const std::string& path_file, const std::string& name) {
  return (std::filesystem::path(path_file).parent_path() / name).string();
}

void read_head(const TomlTable& table, PathDescription& description) {
  description.name = table.required_text("name");
  description.tolerance = table
                              .number("tolerance", {.at_least = kSmallestPathTolerance,
                                                    .at_most = kLargestPathTolerance})
                              .value_or(1e-8);
  description.material_name = table.required_text("material");
  description.material_file = table.text("material_file").value_or("");
  table.finish();
  try {
    description.material = find_path_material(description.material_name, description.material_file,
                                              description.source);
  } catch (const BadInput& error) {
    if (!description.material_file.empty()) throw;
    table.fail("material", error.what());
  }
  if (!description.material_file.empty())
    description.files.push_back(beside(description.source, description.material_file));
}

void read_parameters(const std::optional<TomlTable>& table, PathDescription& description) {
  if (!table) return;
  for (const std::string& key : table->keys()) {
    const std::string value = *table->scalar(key);
    try {
      description.material = with_parameter(description.material, key, value);
    } catch (const BadInput& error) {
      table->fail(key, error.what());
    }
    description.parameters.emplace_back(key, value);
  }
}

template <class Space>
sim::Vector<Space> stress_from(double axial_pa, double radial_pa) {
  auto s = sim::components(sim::AxisymmetricStress{axial_pa, radial_pa});
  if constexpr (Space::kSize == 2)
    return s;
  else
    return sim::as_tensor(s);
}

template <class Space>
sim::Vector<Space> read_stress(const TomlTable& table) {
  constexpr Bounds kStress{.at_least = -kLargestPressure_kPa, .at_most = kLargestPressure_kPa};
  const auto p = table.number(
      "p_eff_kPa", {.at_least = kSmallestPathStress_kPa, .at_most = kLargestPressure_kPa});
  if (p && table.has("stress_kPa")) table.fail("stress_kPa", "give either p_eff_kPa or stress_kPa");
  if (p) return stress_from<Space>(1e3 * *p, 1e3 * *p);
  if (!table.has("stress_kPa"))
    table.fail("",
               "the effective stress is missing: p_eff_kPa = 100, or stress_kPa = {axial = "
               "120, radial = 100}, or stress_kPa = [six components]");
  if (table.is_table("stress_kPa")) {
    const TomlTable stress = table.required_table("stress_kPa");
    const double axial = 1e3 * stress.required_number("axial", kStress);
    const double radial = 1e3 * stress.required_number("radial", kStress);
    stress.finish();
    return stress_from<Space>(axial, radial);
  }
  const auto values = table.numbers("stress_kPa");
  if (values.size() != 6 ||
      !std::ranges::all_of(values, [&](double value) { return kStress.hold(value); }))
    table.fail("stress_kPa", "expected six components 11, 22, 33, 12, 13, 23 within 100000 kPa");
  if constexpr (Space::kSize == 6) {
    sim::Vector<Space> stress;
    for (int i = 0; i < 6; ++i)
      stress(i) = 1e3 * values[static_cast<std::size_t>(i)] * (i < 3 ? 1 : std::numbers::sqrt2);
    return stress;
  } else {
    throw std::logic_error("six components were to be read in the space of tensors");
  }
}

template <class Space>
void read_start(const TomlTable& table, sim::Path<Space>& path) {
  path.stress = read_stress<Space>(table);
  path.void_ratio = table.required_number(
      "void_ratio", {.at_least = kSmallestVoidRatio, .at_most = kLargestVoidRatio});
  path.pore_pressure =
      1e3 * table.number("pore_pressure_kPa", {.at_least = -100, .at_most = kLargestPressure_kPa})
                .value_or(0);
  path.memory = table.numbers("memory");
  table.finish();
}

template <class Space>
sim::PathEnd read_end(const TomlTable& table) {
  const std::string word = table.required_text("quantity");
  const PathQuantityKey* key = nullptr;
  std::vector<std::string> known;
  for (const PathQuantityKey& candidate : path_quantity_keys()) {
    if (Space::kSize == 2 && candidate.quantity >= sim::PathQuantity::strain_component) continue;
    known.emplace_back(candidate.key);
    if (candidate.key == word) key = &candidate;
  }
  if (key == nullptr) table.fail("quantity", invalid_value(word, known));
  const Bounds bounds{.at_least = key->lowest, .at_most = key->highest};
  const auto above = table.number("above", bounds), below = table.number("below", bounds);
  table.finish();
  if (above.has_value() == below.has_value())
    table.fail("", "an end condition needs exactly one of above and below");
  sim::PathEnd end{.quantity = key->quantity, .component = key->component};
  if (above) end.above = *above * key->scale;
  if (below) end.below = *below * key->scale;
  end.label = fmt::format("{} {} {:g}", word, above ? "above" : "below", above ? *above : *below);
  return end;
}

/// What a segment says beside its conditions.
template <class Space>
sim::Segment<Space> read_rest(const TomlTable& table, const std::vector<std::string>& names) {
  sim::Segment<Space> segment;
  segment.name = table.required_text("name");
  if (std::ranges::find(names, segment.name) != names.end())
    table.fail("name", fmt::format("{} is the name of an earlier segment", excerpt(segment.name)));
  const std::string drainage = table.required_text("drainage");
  if (drainage != "drained" && drainage != "undrained")
    table.fail("drainage",
               fmt::format("{} is not valid; expected drained or undrained", excerpt(drainage)));
  segment.undrained = drainage == "undrained";
  segment.repeat = static_cast<int>(table.integer("repeat", 1, 100000).value_or(1));
  segment.repeat_from = names.size();
  if (const auto from = table.text("repeat_from")) {
    if (!table.has("repeat")) table.fail("repeat_from", "needs repeat = N, the number of runs");
    const auto found = std::ranges::find(names, *from);
    if (found == names.end() && *from != segment.name)
      table.fail("repeat_from", fmt::format("{} is not an earlier segment; {}", excerpt(*from),
                                            suggestion(*from, names)));
    segment.repeat_from = static_cast<std::size_t>(found - names.begin());
  }
  for (const TomlTable& end : table.tables("end")) segment.end.push_back(read_end<Space>(end));
  return segment;
}

template <class Space>
void set_conditions(const TomlTable& table, std::string_view key,
                    const std::vector<Condition<Space>>& conditions, sim::Segment<Space>& segment) {
  if (conditions.size() != static_cast<std::size_t>(Space::kSize))
    table.fail(key, fmt::format("{} conditions are given; expected {} in the frame {}",
                                conditions.size(), static_cast<std::size_t>(Space::kSize),
                                table.text("frame").value_or("triaxial")));
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    segment.conditions.stress.row(row) = conditions[i].left.stress;
    segment.conditions.strain.row(row) = conditions[i].left.strain;
    segment.conditions.increment(row) = conditions[i].total;
    segment.labels.push_back(conditions[i].label);
  }
  try {
    static_cast<void>(sim::effective_control(segment));
  } catch (const std::invalid_argument& error) {
    table.fail(key, error.what());
  }
}

template <class Space>
std::vector<sim::Segment<Space>> read_ramp(const TomlTable& table, sim::Segment<Space> segment) {
  std::vector<Condition<Space>> conditions;
  for (const std::string& text : table.texts("conditions")) try {
      conditions.push_back(read_condition<Space>(text));
    } catch (const std::invalid_argument& error) {
      table.fail("conditions", fmt::format("{}: {}", excerpt(text), error.what()));
    }
  segment.rows = static_cast<int>(table.integer("rows", 1, 100000).value_or(200));
  segment.least_parts = static_cast<int>(table.integer("parts", 1, 1000000).value_or(200));
  set_conditions(table, "conditions", conditions, segment);
  if (segment.conditions.increment.isZero(0))
    table.fail("conditions", "all totals are 0; at least one must differ from 0");
  return {segment};
}

/// A segment for each row of the table.
template <class Space>
std::vector<sim::Segment<Space>> read_steps(const TomlTable& table, sim::Segment<Space> segment,
                                            const std::string& file) {
  if (table.has("conditions")) table.fail("table", "give either table or conditions");
  const PathTable steps = read_path_table(file);
  std::vector<Condition<Space>> conditions;
  for (const std::string& heading : steps.headings) try {
      conditions.push_back({read_combination<Space>(heading), heading, 0});
    } catch (const std::invalid_argument& error) {
      throw BadInput(file, 0, fmt::format("heading {}: {}", excerpt(heading), error.what()));
    }
  segment.rows = static_cast<int>(table.integer("rows", 1, 1000).value_or(1));
  segment.least_parts =
      static_cast<int>(table.integer("parts", 1, 1000).value_or(kPartsOfTableRow));
  set_conditions(table, "table", conditions, segment);
  std::vector<sim::Segment<Space>> segments;
  std::vector<double> before(steps.headings.size(), 0);
  for (std::size_t i = 0; i < steps.rows.size(); ++i) {
    for (std::size_t column = 0; column < before.size(); ++column) {
      const double step = steps.rows[i][column] - before[column];
      try {
        check_total(conditions[column].left, step);
      } catch (const std::invalid_argument& error) {
        throw BadInput(file, steps.lines[i], error.what());
      }
      segment.conditions.increment(static_cast<Eigen::Index>(column)) = step;
    }
    before = steps.rows[i];
    if (segment.conditions.increment.isZero(0)) continue;
    segment.goes_on = !segments.empty();
    segments.push_back(segment);
  }
  if (segments.empty()) throw BadInput(file, 0, "all rows are 0; at least one must differ from 0");
  return segments;
}

template <class Space>
std::vector<sim::Segment<Space>> read_segment(const TomlTable& table,
                                              const std::vector<std::string>& names,
                                              PathDescription& description) {
  const auto rest = read_rest<Space>(table, names);
  const auto steps = table.text("table");
  std::vector<sim::Segment<Space>> segments;
  if (steps) {
    const std::string file = beside(description.source, *steps);
    segments = read_steps(table, rest, file);
    description.files.push_back(file);
  } else if (table.has("conditions")) {
    segments = read_ramp(table, rest);
  } else {
    static_cast<void>(table.texts("conditions"));
    table.fail("",
               "conditions are missing: conditions = [\"axial_strain = 0.10\", "
               "\"radial_stress_kPa = 0\"], or table = \"STEPS.csv\"");
  }
  table.finish();
  return segments;
}

bool is_cartesian(const TomlTable& table) {
  const std::string frame = table.text("frame").value_or("triaxial");
  if (std::ranges::find(kFrames, frame) == kFrames.end())
    table.fail("frame", invalid_value(frame, kFrames));
  return frame == "cartesian";
}

template <class Space>
sim::Path<Space> read_in(const TomlTable& start, const std::vector<TomlTable>& tables,
                         PathDescription& description) {
  sim::Path<Space> path;
  read_start(start, path);
  std::vector<std::string> names;
  std::vector<std::size_t> first_of;  // of each name, its first segment
  for (const TomlTable& table : tables) {
    std::vector<sim::Segment<Space>> read;
    if constexpr (Space::kSize == 6) {
      if (is_cartesian(table)) {
        read = read_segment<Space>(table, names, description);
      } else {
        for (const auto& one : read_segment<sim::Axisymmetric>(table, names, description))
          read.push_back(sim::as_tensor_segment(one));
      }
    } else {
      read = read_segment<Space>(table, names, description);
    }
    names.push_back(read.front().name);
    first_of.push_back(path.segments.size());
    const int repeat = read.front().repeat;
    for (auto& segment : read) {
      const auto from = first_of[*segment.repeat_from];
      segment.repeat = 1;
      segment.repeat_from.reset();
      path.segments.push_back(segment);
      if (&segment != &read.back()) continue;
      path.segments.back().repeat = repeat;
      path.segments.back().repeat_from = from;
    }
  }
  return path;
}

}  // namespace

MaterialSet find_path_material(const std::string& name, const std::string& material_file,
                               const std::string& path_file) {
  if (material_file.empty()) return find_material(name);
  const std::string file = beside(path_file, material_file);
  return find_material(name, read_materials(read_text_file(file), file));
}

PathDescription read_path(std::string_view toml_text, const std::string& file) {
  const TomlTable root = TomlTable::parse(toml_text, file);
  PathDescription description;
  description.source = file;
  description.files = {file};
  const TomlTable head = root.required_table("path");
  const auto parameters = root.table("parameters");
  const TomlTable start = root.required_table("start");
  const auto segments = root.tables("segments");
  root.finish();
  read_head(head, description);
  read_parameters(parameters, description);
  if (segments.empty()) throw BadInput(file, 0, "no segment is given; write [[segments]]");
  // Every frame is looked at, so that a wrong one is told as such.
  bool tensor = start.has("stress_kPa") && !start.is_table("stress_kPa");
  for (const TomlTable& segment : segments) tensor = is_cartesian(segment) || tensor;
  if (tensor)
    description.path = read_in<sim::Tensor>(start, segments, description);
  else
    description.path = read_in<sim::Axisymmetric>(start, segments, description);
  check_length(description);
  return description;
}

PathDescription load_path(const std::string& path) { return read_path(read_text_file(path), path); }

}  // namespace triax::lab
