// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/path_result.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lab/paths/path_writer.hpp"
#include "src/study/element/closed_cycles.hpp"
#include "src/study/element/path_columns.hpp"
#include "src/study/number_text.hpp"

namespace triax::study {
namespace {

std::string state_in_words(const PathResult& path, const ResultPoint& at) {
  const auto strain = path.value(at, "axial_strain");
  const auto eta = path.told_eta(at);
  return fmt::format("axial strain {} %, q {} kPa, p' {} kPa",
                     number_text(strain ? std::optional(100 * *strain) : std::nullopt, 3),
                     number_text(path.value(at, "q_kPa"), 3),
                     number_text(path.value(at, "p_eff_kPa"), 3)) +
         (eta ? ", eta " + number_text(eta, 4) : "");
}

/// One sentence for the reader of an outcome.
std::string verdict(const PathResult& path, const std::string& message) {
  if (path.outcome == sim::StepOutcome::accepted) return {};
  if (path.outcome == sim::StepOutcome::inaccurate)
    return fmt::format("{}: estimated error {:.1e}, tolerance {:.1e}", message, path.error,
                       path.tolerance);
  const std::string where =
      fmt::format("segment {}, {} % completed, {}", path.last.segment,
                  number_text(100 * path.value(path.last, "progress").value_or(0), 2),
                  state_in_words(path, path.last));
  if (path.outcome == sim::StepOutcome::lost_control)
    return fmt::format("control of {} is lost ({}): {}", path.limiting_variable, message, where);
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
      const auto strain = finite(sim::value_of(sim::PathQuantity::axial_strain, 0, rows[i]));
      const std::string where = i == 0 || !strain ? "at the start"
                                                  : fmt::format("from axial strain {} % on",
                                                                number_text(100 * *strain, 3));
      warnings.push_back(where + ' ' + *words);
      return;
    }
  };
  first([&set](const auto& at) { return lab::void_ratio_outside(set, at.void_ratio); });
  first([&set](const auto& at) {
    const auto p = finite(sim::value_of(sim::PathQuantity::mean_effective_stress, 0, at));
    return p ? lab::p_eff_outside(set, *p) : std::nullopt;
  });
}

}  // namespace

bool PathResult::went_to_the_end() const {
  return outcome == sim::StepOutcome::accepted || outcome == sim::StepOutcome::inaccurate;
}

std::optional<double> PathResult::value(const ResultPoint& at, const std::string& column) const {
  const auto found = std::ranges::find(columns, column);
  const auto index = static_cast<std::size_t>(found - columns.begin());
  return index < at.values.size() ? at.values[index] : std::nullopt;
}

std::optional<double> PathResult::told_eta(const ResultPoint& at) const {
  constexpr double kNothingLeft = 1e-6;  // of the mean stress at the start
  const auto p = value(at, "p_eff_kPa"), p_at_start = value(start, "p_eff_kPa");
  if (p && p_at_start && *p < kNothingLeft * *p_at_start) return std::nullopt;
  return value(at, "eta");
}

template <class Space>
PathResult path_result(const lab::PathDescription& description,
                       const sim::PathResult<Space>& result) {
  const auto& path = std::get<sim::Path<Space>>(description.path);
  const auto point = [&path](const auto& at) { return result_point(path, at); };
  PathResult out;
  out.name = description.name;
  out.source = description.source;
  out.tolerance = description.tolerance;
  out.material = description.material;
  out.columns = column_names(*description.material.material.template law<Space>());
  out.start = point(result.rows.front());
  out.last = point(result.last);
  if (result.peak) out.peak = point(*result.peak);
  out.outcome = result.outcome;
  out.limiting_variable = result.limiting_variable;
  out.error = result.error;
  for (const auto& event : result.events)
    out.events.push_back({event.kind, event.what, point(event.at)});
  out.warnings = description.warnings;
  out.warnings.insert(out.warnings.end(), result.warnings.begin(), result.warnings.end());
  warn_of_range(description.material, result.rows, out.warnings);
  if (const auto cycle = least_closed_cycle(result))
    if (auto words = gain_in_words(*cycle, path.segments[cycle->segment].name))
      out.warnings.push_back(std::move(*words));
  out.rows.reserve(result.rows.size());
  for (const auto& row : result.rows) out.rows.push_back(point(row));
  out.message = verdict(out, result.message);
  if (result.failed && !description.material_name.empty())
    out.failed_increment = lab::failed_increment_toml(description, *result.failed, out.message);
  return out;
}

template PathResult path_result(const lab::PathDescription&,
                                const sim::PathResult<sim::Axisymmetric>&);
template PathResult path_result(const lab::PathDescription&, const sim::PathResult<sim::Tensor>&);

}  // namespace triax::study
