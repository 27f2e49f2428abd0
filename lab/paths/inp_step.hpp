// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/paths/incremental_driver_reader.hpp"
#include "lab/paths/inp_frame.hpp"
#include "lab/paths/inp_lines.hpp"

namespace triax::lab {

/// One step of a test.inp, between the keyword and what it makes of the path.
struct InpStep {
  std::string keyword;
  int increments = 1, every = 1;              ///< every so many increments one is written
  double duration = 0;                        ///< s
  sim::MixedControl<sim::Tensor> conditions;  ///< totals; of *CirculatingLoad its linear part
  std::vector<std::string> labels;
  std::vector<sim::PathEnd> end;
  // Oscillation on top of the totals: amplitude sin(2π t/duration + phase), t since the first step.
  bool circulating = false;
  sim::Vector<sim::Tensor> amplitude = sim::Vector<sim::Tensor>::Zero();
  sim::Vector<sim::Tensor> phase = sim::Vector<sim::Tensor>::Zero();
  /// Of *ImportFile: right-hand sides one after another instead of one.
  std::vector<sim::Vector<sim::Tensor>> imported;
};

/// Reads on behind the line of the keyword, which may hold "? CONDITION". Throws BadInput.
InpStep read_inp_step(const std::string& keyword_line, InpLines& lines, const InpFile& file,
                      std::vector<std::string>& files, std::vector<std::string>& warnings);

}  // namespace triax::lab
