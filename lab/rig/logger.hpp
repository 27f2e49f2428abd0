// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The data logger: when a reading is recorded, and over which looks at the transducers it is the
// mean.
#include <array>
#include <vector>

#include "lab/programmes/programme.hpp"
#include "lab/results/reading.hpp"

namespace triax::lab {

class Logger {
 public:
  /// Means are taken in the units of the transducers, so that a file keeps them to the bit; the
  /// steps of their converters say what stands out.
  explicit Logger(const std::array<Transducer, kRawQuantityCount>& transducers);

  /// From the reading just recorded at `time_s` on, readings follow each other at this interval.
  void begin(const Logging& logging, double time_s);
  /// Time of the next reading, s; multiples of the interval from where it began.
  double due_s() const {
    return began_s_ + static_cast<double>(recorded_ + 1) * logging_.interval_s;
  }

  /// A look on the way to the next reading; looks before its averaging window count for nothing.
  void add(const Reading& look);
  /// The reading now due: `look`, taken at that time; where the logger averages, each raw channel
  /// is the mean of what it said in the window (t − averaging, t], this look among them, without
  /// what stands out: a spike in some looks does not show. Looks that a channel misses do not
  /// count. The next reading is waited for from here on.
  Reading record(const Reading& look);

 private:
  std::array<sim::Unit, kRawQuantityCount> units_;
  std::array<double, kRawQuantityCount> steps_{};
  std::array<std::vector<double>, kRawQuantityCount> looks_;  ///< of the window, in those units
  Logging logging_;
  double began_s_ = 0;
  std::int64_t recorded_ = -1;  ///< since it began
};

}  // namespace triax::lab
