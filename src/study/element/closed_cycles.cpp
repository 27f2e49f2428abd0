// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/element/closed_cycles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace triax::study {
namespace {

constexpr double kSameStress = 1e-6, kNegligibleGain = 2e-3;
constexpr std::size_t kMostSegments = 16, kFewestRows = 100;

/// The end of a segment, and the sums from the start of the path to there.
struct SegmentEnd {
  std::size_t row = 0;
  double work = 0, exchanged = 0;
};

template <class Space>
std::vector<SegmentEnd> ends_of(const std::vector<sim::PathPoint<Space>>& rows) {
  std::vector<SegmentEnd> ends{{}};
  SegmentEnd sum;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double work =
        (rows[i].stress + rows[i - 1].stress).dot(rows[i].strain - rows[i - 1].strain) / 2;
    sum = {i, sum.work + work, sum.exchanged + std::abs(work)};
    const bool last = i + 1 == rows.size() || rows[i + 1].segment != rows[i].segment ||
                      rows[i + 1].progress <= rows[i].progress;
    if (last) ends.push_back(sum);
  }
  return ends;
}

}  // namespace

template <class Space>
std::optional<ClosedCycle> least_closed_cycle(const sim::PathResult<Space>& result) {
  const auto ends = ends_of(result.rows);
  std::optional<ClosedCycle> least;
  for (std::size_t j = 1; j < ends.size(); ++j) {
    const auto& to = result.rows[ends[j].row];
    for (std::size_t i = j; i-- > (j > kMostSegments ? j - kMostSegments : 0);) {
      const auto& from = result.rows[ends[i].row];
      if (ends[j].row - ends[i].row < kFewestRows ||
          (to.stress - from.stress).norm() > kSameStress * from.stress.norm())
        continue;
      const ClosedCycle cycle{to.segment, ends[j].work - ends[i].work,
                              ends[j].exchanged - ends[i].exchanged};
      if (!least || cycle.work < least->work) least = cycle;
    }
  }
  return least;
}

std::optional<std::string> gain_in_words(const ClosedCycle& cycle, const std::string& segment) {
  if (-cycle.work <= kNegligibleGain * cycle.exchanged) return std::nullopt;
  return fmt::format(
      "the closed cycle of stress that ends with segment {} gains {:.4g} J/m³: the elastic "
      "stiffness of the law has no potential (if the law has this parameter, use hyperelastic = 1)",
      segment, -cycle.work);
}

template std::optional<ClosedCycle> least_closed_cycle(const sim::PathResult<sim::Axisymmetric>&);
template std::optional<ClosedCycle> least_closed_cycle(const sim::PathResult<sim::Tensor>&);

}  // namespace triax::study
