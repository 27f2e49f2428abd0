// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "lab/results/record_header.hpp"

namespace triax::study {

struct TestResult;

/// Which of some tests were simulated, and with what.
struct TestsOrigin {
  std::size_t tests = 0;               ///< all of them
  std::vector<std::string> simulated;  ///< names of those that were simulated, in order
  std::vector<std::string> materials;  ///< these were simulated with, each once

  void add(const lab::RecordHeader& header);
  bool all_simulated() const { return simulated.size() == tests; }
};

/// Each file once (read_again.hpp).
TestsOrigin origin_of(const std::vector<TestResult>& tests);

}  // namespace triax::study
