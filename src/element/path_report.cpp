#include "src/element/path_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/mechanics/units.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

using enum sim::PathQuantity;

/// A column that is a quantity of the point.
struct QuantityColumn {
  std::string_view name;
  sim::PathQuantity quantity;
  int component = 0;
  bool in_kPa = false;
};
constexpr auto kQuantities = std::to_array<QuantityColumn>({
    {"axial_strain", axial_strain},
    {"radial_strain", radial_strain},
    {"volumetric_strain", volumetric_strain},
    {"shear_strain", shear_strain},
    {"p_eff_kPa", mean_effective_stress, 0, true},
    {"q_kPa", deviator_stress, 0, true},
    {"eta", stress_ratio},
    {"effective_axial_stress_kPa", effective_axial_stress, 0, true},
    {"effective_radial_stress_kPa", effective_radial_stress, 0, true},
    {"pore_pressure_kPa", pore_pressure, 0, true},
    {"void_ratio", void_ratio},
});
constexpr auto kComponents = std::to_array<QuantityColumn>({
    {"strain_11", strain_component, 0},
    {"strain_22", strain_component, 1},
    {"strain_33", strain_component, 2},
    {"strain_12", strain_component, 3},
    {"strain_13", strain_component, 4},
    {"strain_23", strain_component, 5},
    {"effective_stress_11_kPa", effective_stress_component, 0, true},
    {"effective_stress_22_kPa", effective_stress_component, 1, true},
    {"effective_stress_33_kPa", effective_stress_component, 2, true},
    {"effective_stress_12_kPa", effective_stress_component, 3, true},
    {"effective_stress_13_kPa", effective_stress_component, 4, true},
    {"effective_stress_23_kPa", effective_stress_component, 5, true},
});

std::optional<double> finite(std::optional<double> value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

template <class Space>
void put_quantities(const sim::PathPoint<Space>& at, std::span<const QuantityColumn> columns,
                    std::vector<std::optional<double>>& values) {
  static const sim::Unit kPa = *sim::find_unit("kPa");
  for (const QuantityColumn& column : columns) {
    auto value = finite(sim::value_of(column.quantity, column.component, at));
    if (value && column.in_kPa) value = sim::to_field(*value, kPa);
    values.push_back(value);
  }
}

template <class Space>
ReportedPoint reported_point(const sim::Path<Space>& path, const sim::PathPoint<Space>& at) {
  ReportedPoint point;
  if (at.segment < path.segments.size()) point.segment = path.segments[at.segment].name;
  point.values.push_back(at.progress);
  put_quantities(at, kQuantities, point.values);
  point.values.push_back(finite(at.second_order_work));
  point.values.push_back(finite(at.determinant));
  if constexpr (Space::kSize == 6) put_quantities(at, kComponents, point.values);
  for (const double value : at.memory) point.values.push_back(finite(value));
  return point;
}

template <class Space>
std::vector<std::string> column_names(const sim::Law<Space>& law) {
  std::vector<std::string> names = {"progress"};
  for (const auto& column : kQuantities) names.emplace_back(column.name);
  names.insert(names.end(), {"second_order_work_normalised", "control_determinant"});
  if constexpr (Space::kSize == 6)
    for (const auto& column : kComponents) names.emplace_back(column.name);
  for (const auto& name : law.memory_names()) names.push_back("memory." + name);
  return names;
}

std::string word_of(sim::StepOutcome outcome) {
  switch (outcome) {
    case sim::StepOutcome::accepted:
      return "accepted";
    case sim::StepOutcome::inaccurate:
      return "inaccurate";
    case sim::StepOutcome::lost_control:
      return "lost_control";
    case sim::StepOutcome::failed:
      break;
  }
  return "failed";
}

std::string word_of(sim::PathEventKind kind) {
  switch (kind) {
    case sim::PathEventKind::end_condition:
      return "end_condition";
    case sim::PathEventKind::second_order_work:
      return "second_order_work";
    case sim::PathEventKind::peak:
      return "peak";
    case sim::PathEventKind::control_limit:
      break;
  }
  return "control_limit";
}

std::string state_in_words(const ReportedPath& path, const ReportedPoint& at) {
  const auto strain = path.value(at, "axial_strain");
  const auto eta = path.told_eta(at);
  return fmt::format("axial strain {} %, q {} kPa, p' {} kPa",
                     number(strain ? std::optional(100 * *strain) : std::nullopt, 3),
                     number(path.value(at, "q_kPa"), 3), number(path.value(at, "p_eff_kPa"), 3)) +
         (eta ? ", eta " + number(eta, 4) : "");
}

/// One sentence for the reader of an outcome.
std::string verdict(const ReportedPath& path, const std::string& message) {
  if (path.outcome == "accepted") return {};
  if (path.outcome == "inaccurate")
    return fmt::format("{}: estimated error {:.1e}, tolerance {:.1e}", message, path.error,
                       path.tolerance);
  const std::string where =
      fmt::format("segment {} at {} % of it, {}", path.last.segment,
                  number(100 * path.value(path.last, "progress").value_or(0), 2),
                  state_in_words(path, path.last));
  if (path.outcome == "lost_control")
    return fmt::format("control of {} is lost, {}: {}", path.culprit, message, where);
  return fmt::format("{}: {}", message, where);
}

/// Where the path first leaves what its set is for, one warning for each of e and p'.
template <class Space>
void warn_of_range(const lab::MaterialSet& set, const std::vector<sim::PathPoint<Space>>& rows,
                   std::vector<std::string>& warnings) {
  const auto first = [&](const auto& outside) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto words = outside(rows[i]);
      if (!words) continue;
      const auto strain = finite(sim::value_of(axial_strain, 0, rows[i]));
      const std::string where =
          i == 0 || !strain ? "at the start"
                            : fmt::format("from axial strain {} % on", number(100 * *strain, 3));
      warnings.push_back(where + ' ' + *words);
      return;
    }
  };
  first([&set](const auto& at) { return lab::void_ratio_outside(set, at.void_ratio); });
  first([&set](const auto& at) {
    const auto p = finite(sim::value_of(mean_effective_stress, 0, at));
    return p ? lab::p_eff_outside(set, *p) : std::nullopt;
  });
}

}  // namespace

std::optional<double> ReportedPath::value(const ReportedPoint& at,
                                          const std::string& column) const {
  const auto found = std::ranges::find(columns, column);
  const auto index = static_cast<std::size_t>(found - columns.begin());
  return index < at.values.size() ? at.values[index] : std::nullopt;
}

std::optional<double> ReportedPath::told_eta(const ReportedPoint& at) const {
  constexpr double kNothingLeft = 1e-6;  // of the mean stress at the start
  const auto p = value(at, "p_eff_kPa"), p_at_start = value(start, "p_eff_kPa");
  if (p && p_at_start && *p < kNothingLeft * *p_at_start) return std::nullopt;
  return value(at, "eta");
}

template <class Space>
ReportedPath reported_path(const lab::PathDescription& description,
                           const sim::PathResult<Space>& result) {
  const auto& path = std::get<sim::Path<Space>>(description.path);
  const auto point = [&path](const auto& at) { return reported_point(path, at); };
  ReportedPath report;
  report.name = description.name;
  report.source = description.source;
  report.tolerance = description.tolerance;
  report.material = description.material;
  report.columns = column_names(*description.material.material.template law<Space>());
  report.start = point(result.rows.front());
  report.last = point(result.last);
  if (result.peak) report.peak = point(*result.peak);
  report.outcome = word_of(result.outcome);
  report.culprit = result.culprit;
  report.error = result.error;
  for (const auto& event : result.events)
    report.events.push_back({word_of(event.kind), event.what, point(event.at)});
  report.warnings = description.warnings;
  report.warnings.insert(report.warnings.end(), result.warnings.begin(), result.warnings.end());
  warn_of_range(description.material, result.rows, report.warnings);
  report.rows.reserve(result.rows.size());
  for (const auto& row : result.rows) report.rows.push_back(point(row));
  report.message = verdict(report, result.message);
  return report;
}

template ReportedPath reported_path(const lab::PathDescription&,
                                    const sim::PathResult<sim::Axisymmetric>&);
template ReportedPath reported_path(const lab::PathDescription&,
                                    const sim::PathResult<sim::Tensor>&);

}  // namespace triax::src
