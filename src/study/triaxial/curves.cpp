// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace triax::study {
namespace {

using Getter = double (*)(const lab::State&);

constexpr std::array<Getter, 4> kWatched = {
    [](const lab::State& s) { return s.q; },
    [](const lab::State& s) { return s.p_eff; },
    [](const lab::State& s) { return s.pore_pressure; },
    [](const lab::State& s) { return s.strain.axial; },
};
constexpr std::size_t kLast = 1;

constexpr std::size_t smallest(std::size_t quantity) { return 2 + 2 * quantity; }
constexpr std::size_t largest(std::size_t quantity) { return 3 + 2 * quantity; }

// Beside its extremes each bucket keeps states at even steps: a collapse is steep but smooth, and
// may fit into a bucket or two.
constexpr std::int64_t kEvenSteps = 8;

// With ten extremes and eight or nine steps, fewer scans per bucket than this gain nothing.
constexpr std::int64_t kSmallestSpan = 20;

}  // namespace

CurveThinner::CurveThinner(std::int64_t scans, std::int64_t buckets)
    : span_((scans + buckets - 1) / buckets) {
  if (span_ < kSmallestSpan) span_ = 1;
}

void CurveThinner::add(const lab::State& state) {
  if (in_bucket_ == 0) extremes_.assign(2 + 2 * kWatched.size(), state);
  extremes_[kLast] = state;
  for (std::size_t i = 0; i < kWatched.size(); ++i) {
    const double value = kWatched[i](state);
    auto& low = extremes_[smallest(i)];
    auto& high = extremes_[largest(i)];
    if (value < kWatched[i](low) || std::isnan(kWatched[i](low))) low = state;
    if (value > kWatched[i](high) || std::isnan(kWatched[i](high))) high = state;
  }
  if (span_ > 1 && in_bucket_ % (span_ / kEvenSteps) == 0) extremes_.push_back(state);
  if (++in_bucket_ == span_) close_bucket();
}

/// The last state of a bucket that is closed was kept with it.
void CurveThinner::keep(const lab::State& state) {
  if (in_bucket_ > 0) extremes_.push_back(state);
}

void CurveThinner::close_bucket() {
  std::sort(extremes_.begin(), extremes_.end(),
            [](const auto& a, const auto& b) { return a.reading < b.reading; });
  for (const auto& state : extremes_)
    if (kept_.empty() || kept_.back().reading != state.reading) kept_.push_back(state);
  extremes_.clear();
  in_bucket_ = 0;
}

std::vector<lab::State> CurveThinner::take() {
  if (in_bucket_ > 0) close_bucket();
  return std::exchange(kept_, {});
}

std::vector<lab::SecondOrderWorkPoint> thin(const std::vector<lab::SecondOrderWorkPoint>& points,
                                            std::int64_t buckets) {
  const auto count = static_cast<std::int64_t>(points.size());
  if (count <= 4 * buckets) return points;
  const std::int64_t span = (count + buckets - 1) / buckets;
  const auto below = [](const auto& a, const auto& b) {
    return a.work.normalised < b.work.normalised;
  };
  std::vector<lab::SecondOrderWorkPoint> kept;
  for (std::int64_t begin = 0; begin < count; begin += span) {
    const auto first = points.begin() + begin;
    const auto last = points.begin() + std::min(count, begin + span);
    const auto [low, high] = std::minmax_element(first, last, below);
    kept.push_back(*std::min(low, high));
    if (low != high) kept.push_back(*std::max(low, high));
  }
  return kept;
}

std::vector<lab::Forecast> thin(const std::vector<lab::Forecast>& forecasts, std::int64_t buckets) {
  const auto count = static_cast<std::int64_t>(forecasts.size());
  if (count <= 4 * buckets) return forecasts;
  const std::int64_t span = (count + buckets - 1) / buckets;
  std::vector<lab::Forecast> kept;
  for (std::int64_t begin = 0; begin < count; begin += span)
    kept.push_back(forecasts[static_cast<std::size_t>(std::min(count, begin + span) - 1)]);
  return kept;
}

}  // namespace triax::study
