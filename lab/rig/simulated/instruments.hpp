// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The transducers of the rig with their faults: from the plant's true values to what a logger
// reads.
#include <array>
#include <vector>

#include "lab/devices/faulty_channel.hpp"
#include "lab/devices/transducer.hpp"
#include "lab/results/reading.hpp"
#include "lab/rig/simulated/plant.hpp"

namespace triax::lab {

class Instruments {
 public:
  Instruments(const Programme& programme, std::uint64_t seed);

  /// In place of those of the programme; of all devices. What was read before stays remembered.
  void set_faults(const std::vector<Fault>& faults);
  /// Fills the raw channels of `reading` with what they say at `time_s` (never decreasing). Noise
  /// depends on seed, channel and number of the sample only.
  void look(const Plant& plant, double time_s, Reading& reading);
  /// Whether a transducer stood at the end of its range at the last look.
  bool saturated(Quantity channel) const { return saturated_[index(channel)]; }

 private:
  FittedChannels fitted_;
  std::array<Transducer, kRawQuantityCount> transducers_;
  std::array<TransducerState, kRawQuantityCount> states_{};
  std::vector<FaultyChannel> faults_;  ///< one a channel
  std::array<bool, kRawQuantityCount> saturated_{};
  std::uint64_t seed_;
};

}  // namespace triax::lab
