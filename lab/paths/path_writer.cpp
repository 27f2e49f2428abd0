// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/path_writer.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "lab/base/text.hpp"
#include "lab/base/toml_number.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/paths/condition_text.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

std::string kPa(double pa) { return toml_number(sim::to_field(pa, *sim::find_unit("kPa"))); }

/// True where the label is what the reader would make this row of.
template <class Space>
bool says(const std::string& label, const sim::MixedControl<Space>& conditions, int row) {
  try {
    const auto left = read_combination<Space>(label);
    return left.stress.isApprox(conditions.stress.row(row), 1e-14) &&
           left.strain.isApprox(conditions.strain.row(row), 1e-14);
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// The row in components, for one that came by another way than the text of a condition.
template <class Space>
std::string in_components(const sim::MixedControl<Space>& c, int row) {
  using std::numbers::sqrt2;
  std::string text;
  const auto add = [&text](double factor, const std::string& name) {
    if (factor == 0) return;
    text += fmt::format("{}{} {}",
                        factor < 0     ? " - "
                        : text.empty() ? ""
                                       : " + ",
                        std::abs(factor), name);
  };
  for (int i = 0; i < Space::kSize; ++i) {
    std::string component;
    double unit = i < 3 ? 1 : sqrt2;
    if constexpr (Space::kSize == 2) {
      component = i == 0 ? "axial" : "radial";
      unit = i == 0 ? 1 : sqrt2;
      add(1e3 * unit * c.stress(row, i), component + "_stress_kPa");
      add(unit * c.strain(row, i), component + "_strain");
    } else {
      component = std::to_string(std::array{11, 22, 33, 12, 13, 23}[static_cast<std::size_t>(i)]);
      add(1e3 * unit * c.stress(row, i), "stress_" + component + "_kPa");
      add(unit * c.strain(row, i), "strain_" + component);
    }
  }
  return std::string(trimmed(text));
}

template <class Space>
std::string stress_toml(const sim::Vector<Space>& stress) {
  using std::numbers::sqrt2;
  if constexpr (Space::kSize == 2)
    return fmt::format("{{axial = {}, radial = {}}}", kPa(stress(0)), kPa(stress(1) / sqrt2));
  std::vector<std::string> values;
  values.reserve(Space::kSize);
  for (int i = 0; i < Space::kSize; ++i) values.push_back(kPa(stress(i) / (i < 3 ? 1 : sqrt2)));
  return "[" + joined(values) + "]";
}

/// A remark of one line whatever the text holds.
std::string remark(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = ' ';
  return text;
}

}  // namespace

template <class Space>
std::string failed_increment_toml(const PathDescription& description,
                                  const sim::FailedIncrement<Space>& failed,
                                  const std::string& message) {
  std::string text = fmt::format("# From {}, segment {}: {}\n[path]\nname = {}\n",
                                 remark(description.source), remark(failed.segment.name),
                                 remark(message), toml_quoted("failure of " + description.name));
  text += fmt::format("tolerance = {}\nmaterial = {}\n", description.tolerance,
                      toml_quoted(description.material_name));
  if (!description.material_file.empty())
    text += fmt::format("material_file = {}\n",
                        toml_quoted(std::filesystem::absolute(
                                        std::filesystem::path(description.source).parent_path() /
                                        description.material_file)
                                        .string()));
  if (!description.parameters.empty()) text += "\n[parameters]\n";
  for (const auto& [key, value] : description.parameters)
    text += fmt::format("{} = {}\n", key, toml_quoted(value));
  text += fmt::format("\n[start]\nstress_kPa = {}\nvoid_ratio = {}\npore_pressure_kPa = {}\n",
                      stress_toml<Space>(failed.from.stress), toml_number(failed.from.void_ratio),
                      kPa(failed.from.pore_pressure));
  if (!failed.from.memory.empty()) {
    std::vector<std::string> values;
    for (const double value : failed.from.memory) values.push_back(toml_number(value));
    text += "memory = [" + joined(values) + "]\n";
  }
  const sim::Segment<Space>& segment = failed.segment;
  text += fmt::format("\n[[segments]]\nname = {}\nframe = \"{}\"\ndrainage = \"{}\"\nrows = 1\n",
                      toml_quoted(segment.name), Space::kSize == 2 ? "triaxial" : "cartesian",
                      segment.undrained ? "undrained" : "drained");
  text += "parts = 1\nconditions = [\n";
  for (int row = 0; row < Space::kSize; ++row) {
    std::string label = static_cast<std::size_t>(row) < segment.labels.size()
                            ? segment.labels[static_cast<std::size_t>(row)]
                            : "";
    if (!says(label, segment.conditions, row)) label = in_components(segment.conditions, row);
    text += fmt::format(
        "  {},\n", toml_quoted(fmt::format("{} = {}", label, segment.conditions.increment(row))));
  }
  return text + "]\n";
}

template std::string failed_increment_toml(const PathDescription&,
                                           const sim::FailedIncrement<sim::Axisymmetric>&,
                                           const std::string&);
template std::string failed_increment_toml(const PathDescription&,
                                           const sim::FailedIncrement<sim::Tensor>&,
                                           const std::string&);

}  // namespace triax::lab
