#include "lab/rig/logger.hpp"

#include <cmath>

namespace triax::lab {

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
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    const double si = look.si[i];
    if (std::isnan(si)) continue;
    means_[i].sum += sim::to_field(si, units_[i]);
    ++means_[i].count;
  }
}

Reading Logger::record(const Reading& look) {
  Reading reading = look;
  if (logging_.averaging_s > 0) {
    add(look);
    for (std::size_t i = 0; i < kRawQuantityCount; ++i)
      if (means_[i].count > 1)
        reading.si[i] = sim::to_si(means_[i].sum / means_[i].count, units_[i]);
  }
  means_ = {};
  ++recorded_;
  return reading;
}

}  // namespace triax::lab
