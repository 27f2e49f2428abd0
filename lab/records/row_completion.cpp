// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/row_completion.hpp"

#include <algorithm>
#include <utility>

namespace triax::lab {

using enum Quantity;

struct RowCompletion::Step {
  Quantity target;
  std::vector<SourceQuantity> sources;
  std::vector<Quantity> columns;
  double (*value)(const RowValues& row, double first_height);
};

namespace {

using S = SourceQuantity;
using Step = RowCompletion::Step;

double of(const RowValues& row, S source) { return row.source[index(source)]; }
double of(const RowValues& row, Quantity quantity) { return row.si[index(quantity)]; }

/// The first that applies to a target is taken.
const std::vector<Step>& all_steps() {
  static const std::vector<Step> steps{
      {pore_pressure,
       {},
       {excess_pore_pressure, back_pressure},
       [](const RowValues& r, double) {
         return of(r, back_pressure) + of(r, excess_pore_pressure);
       }},
      {deviator_stress,
       {S::half_deviator_stress},
       {},
       [](const RowValues& r, double) { return 2 * of(r, S::half_deviator_stress); }},
      {deviator_stress,
       {S::deviator_stress_uncorrected},
       {},
       [](const RowValues& r, double) { return of(r, S::deviator_stress_uncorrected); }},
      {mean_effective_stress,
       {S::mean_effective_stress_2d},
       {deviator_stress},
       [](const RowValues& r, double) {
         return of(r, S::mean_effective_stress_2d) - of(r, deviator_stress) / 6;
       }},
      {mean_effective_stress,
       {S::mean_stress},
       {pore_pressure},
       [](const RowValues& r, double) { return of(r, S::mean_stress) - of(r, pore_pressure); }},
      {radial_stress,
       {S::mean_stress},
       {deviator_stress},
       [](const RowValues& r, double) {
         return of(r, S::mean_stress) - of(r, deviator_stress) / 3;
       }},
      {effective_radial_stress,
       {S::principal_stress_ratio},
       {deviator_stress},
       [](const RowValues& r, double) {
         const double ratio = of(r, S::principal_stress_ratio);
         return ratio > 1 ? of(r, deviator_stress) / (ratio - 1) : kMissing;
       }},
      {effective_axial_stress,
       {S::principal_stress_ratio},
       {effective_radial_stress},
       [](const RowValues& r, double) {
         return of(r, S::principal_stress_ratio) * of(r, effective_radial_stress);
       }},
      {back_volume,
       {S::volume_change},
       {},
       [](const RowValues& r, double) { return -of(r, S::volume_change); }},
      {axial_displacement,
       {S::specimen_height},
       {},
       [](const RowValues& r, double height) { return height - of(r, S::specimen_height); }},
  };
  return steps;
}

template <class T>
bool has(const std::vector<T>& all, const T& one) {
  return std::ranges::find(all, one) != all.end();
}

}  // namespace

const std::array<SourceInfo, kSourceCount>& source_quantities() {
  static constexpr std::array<SourceInfo, kSourceCount> infos{{
      {S::mean_stress, "mean_stress", "kPa"},
      {S::mean_effective_stress_2d, "mean_effective_stress_2d", "kPa"},
      {S::half_deviator_stress, "half_deviator_stress", "kPa"},
      {S::principal_stress_ratio, "principal_stress_ratio", ""},
      {S::volume_change, "volume_change", "mm3"},
      {S::specimen_height, "specimen_height", "mm"},
      {S::deviator_stress_uncorrected, "deviator_stress_uncorrected", "kPa"},
  }};
  return infos;
}

std::optional<SourceQuantity> find_source_quantity(std::string_view name) {
  for (const SourceInfo& info : source_quantities())
    if (info.name == name) return info.quantity;
  return std::nullopt;
}

RowCompletion::RowCompletion(std::vector<Quantity> columns,
                             const std::vector<SourceQuantity>& sources,
                             std::vector<RowConstant> constants)
    : constants_(std::move(constants)), quantities_(std::move(columns)), unused_(sources) {
  for (const RowConstant& constant : constants_)
    if (!has(quantities_, constant.quantity)) quantities_.push_back(constant.quantity);
  for (const Step& step : all_steps()) {
    const bool applies =
        !has(quantities_, step.target) &&
        std::ranges::all_of(step.sources, [&](S one) { return has(sources, one); }) &&
        std::ranges::all_of(step.columns, [&](Quantity one) { return has(quantities_, one); });
    if (!applies) continue;
    steps_.push_back(&step);
    quantities_.push_back(step.target);
    for (const S one : step.sources) std::erase(unused_, one);
  }
  std::ranges::sort(quantities_);
}

void RowCompletion::complete(RowValues& row) {
  for (const RowConstant& constant : constants_) row.si[index(constant.quantity)] = constant.si;
  const double height = of(row, S::specimen_height);
  if (std::isnan(first_height_)) first_height_ = height;
  for (const Step* step : steps_) row.si[index(step->target)] = step->value(row, first_height_);
}

}  // namespace triax::lab
