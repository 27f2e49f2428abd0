#include "lab/rig/logger.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace triax::lab {
namespace {

/// Mean of the middle half, all of them where there are fewer than four.
double middle_mean(std::vector<double>& values) {
  const auto quarter = static_cast<std::ptrdiff_t>(values.size() / 4);
  std::ranges::sort(values);
  const auto first = values.begin() + quarter, last = values.end() - quarter;
  return std::accumulate(first, last, 0.0) / static_cast<double>(last - first);
}

}  // namespace

Logger::Logger(const std::array<Transducer, kRawQuantityCount>& transducers) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) units_[i] = transducers[i].unit;
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
    if (looks_[i].size() > 1) reading.si[i] = sim::to_si(middle_mean(looks_[i]), units_[i]);
    looks_[i].clear();
  }
  ++recorded_;
  return reading;
}

}  // namespace triax::lab
