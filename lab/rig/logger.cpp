// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/logger.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lab/base/statistics.hpp"

namespace triax::lab {
namespace {

/// Mean of what stands out of the median by no more than kOutlier standard deviations, which the
/// median deviation tells, or as many steps of the converter: a median alone would stand still
/// where noise moves a converter by one step now and then.
double sound_mean(std::vector<double> values, double step) {
  constexpr double kOutlier = 6, kOfNormal = 1.4826;
  const double middle = median(values);
  std::vector<double> off(values.size());
  std::ranges::transform(values, off.begin(), [&](double v) { return std::fabs(v - middle); });
  const double allowed = kOutlier * std::max(kOfNormal * median(std::move(off)), step);
  std::erase_if(values, [&](double v) { return std::fabs(v - middle) > allowed; });
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Logger::Logger(const std::array<Transducer, kRawQuantityCount>& transducers) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    units_[i] = transducers[i].unit;
    steps_[i] = transducers[i].step;
  }
}

void Logger::begin(const Logging& logging, double time_s) {
  logging_ = logging;
  began_s_ = time_s;
  recorded_ = 0;
}

void Logger::add(const Reading& look) {
  if (!(look.time_s > due_s() - logging_.averaging_s)) return;
  for (std::size_t i = 0; i < kRawQuantityCount; ++i)
    if (!std::isnan(look.si[i])) looks_[i].push_back(sim::to_field(look.si[i], units_[i]));
}

Reading Logger::record(const Reading& look) {
  Reading reading = look;
  if (logging_.averaging_s > 0) add(look);
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    if (looks_[i].size() > 1)
      reading.si[i] = sim::to_si(sound_mean(looks_[i], steps_[i]), units_[i]);
    looks_[i].clear();
  }
  // A reading that comes late stands for those that were missed.
  const double intervals = (look.time_s - began_s_) / logging_.interval_s;
  recorded_ = std::max(recorded_ + 1, static_cast<std::int64_t>(std::floor(intervals + 1e-6)));
  return reading;
}

}  // namespace triax::lab
