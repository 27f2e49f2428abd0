#pragma once
#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// An instrument and its converter, in the unit of the field:
///   reading = round((true + offset + noise_rms · n)/step) · step, held within ±range.
/// An imperfection of 0 is absent; with all of them absent the true value passes through.
struct Transducer {
  sim::Unit unit;
  double range = 0;  ///< full scale, both signs; 0: unlimited
  double step = 0;   ///< of the converter; 0: continuous
  double noise_rms = 0;
  double offset = 0;
};

/// Step of a converter of that many bits over −range to +range.
double converter_step(double range, int bits);

struct TransducerReading {
  double si = 0;  ///< always to_si of a number in the unit of the field, so that a file keeps it
  bool saturated = false;  ///< the range ended the reading
};

/// `normal` is the standard normal number of this reading.
TransducerReading read(const Transducer& transducer, double true_si, double normal);

}  // namespace triax::lab
