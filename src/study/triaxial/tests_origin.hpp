// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "db/store.hpp"

namespace triax::study {

struct TestResult;

/// Which of some tests were simulated, and with what.
struct TestsOrigin {
  std::size_t tests = 0;               ///< all of them
  std::vector<std::string> simulated;  ///< names of those that were simulated, in order
  std::vector<std::string> materials;  ///< these were simulated with, each once

  /// Of these a sensor failed: what came after that is not drawn.
  std::vector<std::string> cut;

  void add(const db::StoredTest& test);
  bool all_simulated() const { return simulated.size() == tests; }
};

/// Each file once (read_again.hpp).
TestsOrigin origin_of(const std::vector<TestResult>& tests);

}  // namespace triax::study
