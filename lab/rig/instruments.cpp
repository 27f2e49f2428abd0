// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/instruments.hpp"

namespace triax::lab {

Instruments::Instruments(const Programme& programme, std::uint64_t seed)
    : fitted_(programme.fitted), transducers_(programme.transducers), seed_(seed) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    std::vector<Fault> own;
    for (const Fault& fault : programme.faults)
      if (fault.device == quantities()[i].name) own.push_back(fault);
    faults_.emplace_back(std::move(own), transducers_[i], seed, i);
  }
}

void Instruments::look(const Plant& plant, double time_s, Reading& reading) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    if (!fitted_[i]) continue;
    const Quantity channel = quantities()[i].quantity;
    const TransducerReading seen =
        triax::lab::look(transducers_[i], states_[i], plant.true_value(channel), time_s, seed_, i);
    reading[channel] = faults_[i].pass(seen.si, time_s);
    saturated_[i] = seen.saturated || faults_[i].saturated();
  }
}

}  // namespace triax::lab
