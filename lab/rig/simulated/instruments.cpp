// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/instruments.hpp"

namespace triax::lab {
namespace {

std::vector<Fault> faults_of(const std::vector<Fault>& all, std::string_view device) {
  std::vector<Fault> own;
  for (const Fault& fault : all)
    if (fault.device == device) own.push_back(fault);
  return own;
}

}  // namespace

Instruments::Instruments(const Programme& programme, std::uint64_t seed)
    : fitted_(programme.fitted), transducers_(programme.transducers), seed_(seed) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i)
    faults_.emplace_back(faults_of(programme.faults, quantities()[i].name), transducers_[i], seed,
                         i);
}

void Instruments::set_faults(const std::vector<Fault>& faults) {
  for (std::size_t i = 0; i < kRawQuantityCount; ++i)
    faults_[i].set_faults(faults_of(faults, quantities()[i].name));
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
