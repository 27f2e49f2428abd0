// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/total_stress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/base/statistics.hpp"
#include "src/study/sheet/deviation_parts.hpp"

namespace triax::study {
namespace {

constexpr double kAstmStrain = lab::kAstmFailureStrain;
constexpr double kSlowest = 0.003 / 60, kFastest = 0.01 / 60;  // 1/s, D2850: brittle, plastic
constexpr double kRounding = 1.05;

void add_total_stress_rate(std::vector<std::string>& out, const SheetValues& values) {
  const auto& rate = values.rate_per_s;
  if (!rate) {
    out.emplace_back("no time in the record: the rate is unknown");
    return;
  }
  if (*rate > kRounding * kFastest || kRounding * *rate < kSlowest)
    out.push_back(fmt::format("sheared at {:.3g} %/min; ASTM D2850: 0.3 (brittle) to 1 (plastic)",
                              *rate * 100 * 60));
}

void add_total_stress_failure(std::vector<std::string>& out, const SheetValues& values) {
  if (!values.failure || !values.end) return;
  const double strain = std::abs(values.failure->state.strain.axial);
  const double last = std::abs(values.end->state.strain.axial);
  const bool rising = values.failure->state.reading == values.end->state.reading;
  if (values.options.failure != FailureCriterion::peak_deviator_stress)
    out.emplace_back("failure is not at the largest q, as required by ISO 17892-8 and ASTM D2850");
  else if (rising && last < kLastTotalStrain)
    out.push_back(
        fmt::format("q had not fallen when shear ended at {:.1f} %; ISO 17892-8 requires shear to "
                    "20 %, ASTM D2850 to 15 %",
                    last * 100));
  if (strain > kAstmStrain && values.at_15_pct)
    out.push_back(
        fmt::format("failure beyond 15 %, the failure strain of ASTM D2850: c_u {:.1f} kPa",
                    *undrained_strength(values.at_15_pct) * 1e-3));
}

}  // namespace

std::optional<double> undrained_strength(const std::optional<ScanValues>& failure) {
  if (!failure || !std::isfinite(failure->state.q)) return std::nullopt;
  return std::abs(failure->state.q) / 2;
}

MeanStrength mean_strength(std::span<const double> strengths) {
  const auto [least, largest] = std::ranges::minmax(strengths);
  const auto count = static_cast<double>(strengths.size());
  MeanStrength found{.mean = std::accumulate(strengths.begin(), strengths.end(), 0.0) / count,
                     .least = least,
                     .largest = largest,
                     .standard_deviation = std::nullopt};
  if (strengths.size() < 2) return found;
  found.standard_deviation = lab::standard_deviation({strengths.begin(), strengths.end()});
  return found;
}

std::vector<std::string> total_stress_deviations(const db::StoredTest& test,
                                                 const SheetValues& values,
                                                 const SheetWords& words) {
  std::vector<std::string> out;
  add_origin_deviation(out, test);
  const auto& header = test.header;
  if (header.has(lab::Quantity::pore_pressure))
    out.emplace_back(
        "the pore pressure was measured: not covered by ISO 17892-8 and not used here");
  for (const auto& stage : header.stages)
    if (stage.role == lab::StageRole::consolidation) {
      out.emplace_back("the record has a consolidation stage, which is not part of a UU test");
      break;
    }
  for (const auto& stage : header.stages)
    if (stage.role == lab::StageRole::shear && stage.drainage == lab::Drainage::open) {
      out.emplace_back("sheared with the drainage open, which is not a UU test");
      break;
    }
  if (values.extension) out.emplace_back("sheared in extension; the standards cover compression");
  if (test.summary.cyclic) out.emplace_back("cyclic load is not covered by these standards");
  if (values.start && !std::isfinite(values.start->cell_pressure))
    out.emplace_back("the cell pressure is not in the record");
  add_dimension_deviations(out, header.specimen, 8);
  add_total_stress_rate(out, values);
  add_total_stress_failure(out, values);
  const auto corrections = load_corrections(test, values, words);
  if (corrections.side_drains)
    out.emplace_back("filter drains at the side: ISO 17892-8 does not cover them");
  add_load_deviations(out, values, corrections);
  add_record_deviations(out, test);
  return out;
}

}  // namespace triax::study
