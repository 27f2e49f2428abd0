#include "lab/devices/transducer.hpp"

#include <algorithm>
#include <cmath>

namespace triax::lab {

double converter_step(double range, int bits) { return std::ldexp(range, 1 - bits); }

TransducerReading read(const Transducer& transducer, double true_si, double normal) {
  double field = sim::to_field(true_si, transducer.unit);
  field += transducer.offset + transducer.noise_rms * normal;
  if (transducer.step > 0) field = std::round(field / transducer.step) * transducer.step;
  TransducerReading reading;
  if (transducer.range > 0 && std::abs(field) > transducer.range) {
    field = std::copysign(transducer.range, field);
    reading.saturated = true;
  }
  // −0 would be written as "-0".
  reading.si = sim::to_si(field + 0.0, transducer.unit);
  return reading;
}

}  // namespace triax::lab
