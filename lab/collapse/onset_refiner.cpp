// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/onset_refiner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::lab {
namespace {

constexpr double kGrowth = std::numbers::sqrt2;  ///< from one window to the next
constexpr double kShortest = 1.0 / 9;            ///< right end, over the readings since the onset
constexpr double kFarthestLeft = 4.1;            ///< left end, over the right one
constexpr double kLongest = 3;                   ///< last sweep, over the first
constexpr double kMinRight = 8;                  ///< readings
constexpr double kOneAbove = 0.84;               ///< share below one standard deviation above
constexpr double kAround = 12;                   ///< readings on each side that give values

/// The median of the estimates, each with the weight 1/δt; no weight is finer than half a reading.
/// Its error is its own, or that by which windows of other lengths differ from it: what a cubic
/// cannot follow.
OnsetFit consensus(std::vector<OnsetFit> fits) {
  std::ranges::sort(fits, {}, [](const OnsetFit& f) { return f.point.reading; });
  const auto weight = [](const OnsetFit& f) { return 1 / (f.error + 0.5); };
  double whole = 0;
  for (const OnsetFit& f : fits) whole += weight(f);
  const auto at = [&](double share) -> const OnsetFit& {
    double sum = 0;
    for (const OnsetFit& f : fits) {
      sum += weight(f);
      if (sum >= share * whole) return f;
    }
    return fits.back();
  };
  OnsetFit best = at(0.5);
  const double spread = (at(kOneAbove).point.reading - at(1 - kOneAbove).point.reading) / 2;
  best.error = std::max(best.error, spread);
  return best;
}

}  // namespace

void OnsetRefiner::begin(double reading, Witness witness, const PathHistory& history) {
  const int revision = revision_;
  *this = OnsetRefiner();
  revision_ = revision;
  active_ = true;
  witness_ = witness;
  centre_ = reading;
  swept_ = first_ = history.last_reading() - reading;
  sweep(history, history.last_reading());
}

void OnsetRefiner::follow(const PathHistory& history) {
  if (!active_) return;
  const double age = history.last_reading() - centre_;
  if (age < kGrowth * swept_) return;
  swept_ = age;
  sweep(history, history.last_reading());
  active_ = age < kLongest * first_;
}

void OnsetRefiner::finish(const PathHistory& history, double last_reading) {
  if (active_) sweep(history, last_reading);
  active_ = false;
}

/// One family of windows.
std::optional<OnsetFit> OnsetRefiner::sweep_around(
    const PathHistory& history, double around, double last_reading,
    const std::function<double(double)>& change) const {
  std::vector<OnsetFit> fits;
  const double centre = std::min(around, last_reading - kMinRight);
  const double age = last_reading - centre;
  for (double right = age; right > kShortest * age; right /= kGrowth)           // NOLINT: lengths
    for (double left = right; left < kFarthestLeft * right; left *= kGrowth) {  // NOLINT: lengths
      auto blocks = history.between(centre - left, centre + right);
      if (change)
        for (PathSample& block : blocks)
          block.signal[PathSample::volumetric_strain] +=
              change(block.signal[PathSample::pore_pressure]);
      if (const auto fit = fit_onset(blocks, witness_, around)) fits.push_back(*fit);
    }
  if (fits.empty()) return std::nullopt;
  return consensus(std::move(fits));
}

void OnsetRefiner::sweep(const PathHistory& history, double last_reading) {
  ++revision_;
  // Twice: the second family of windows lies around the median of the first.
  for (int pass = 0; pass < 2; ++pass) {
    const auto found = sweep_around(history, centre_, last_reading, nullptr);
    if (!found) break;
    best_ = found;
    centre_ = best_->point.reading;
  }
  // The windows that place the onset may be too long for its values.
  const auto around = history.between(centre_ - kAround, std::min(centre_ + kAround, last_reading));
  if (best_ && static_cast<double>(around.size()) > kAround)
    best_->point = values_at(around, centre_);
}

std::optional<OnsetFit> OnsetRefiner::with_volume(
    const PathHistory& history, double last_reading,
    const std::function<double(double)>& change) const {
  return sweep_around(history, centre_, last_reading, change);
}

}  // namespace triax::lab
