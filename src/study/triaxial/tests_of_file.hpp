// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The tests of a record file that may hold several, one after the other.
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"

namespace triax::study {

/// One test of a file.
struct TestOfFile {
  std::size_t number = 0;  ///< from 1; 0: the only one
  std::shared_ptr<const lab::TestsInFile> all{};
  /// The options to open it with.
  lab::RecordOptions options(lab::RecordOptions of_file) const;
};

/// At least one; only one has no number if the file has no names of tests.
std::vector<TestOfFile> tests_of(lab::TestsInFile tests);

/// The first test; of tables side by side that of table `block` (from 1).
TestOfFile test_of_block(const std::vector<TestOfFile>& tests, std::size_t block);

/// lab::tests_in() of the file.
using FindTests = std::function<lab::TestsInFile(lab::Extent)>;

/// The tests in the rows after those that a file was sampled at, when reading it as one test has
/// thrown `error`. Throws `error` if there is only one.
std::vector<TestOfFile> tests_in_all_rows(const FindTests& find, const lab::SeveralTests& error);

/// Calls `read` with each test. If the later rows of the only test are of another one (`read`
/// throws SeveralTests), all rows are searched, and `read` is called again with each test that is
/// there. Faults of one of several tests go to `on_fault`, and the next one is read; that of the
/// only test is thrown.
void read_tests(const FindTests& find, const std::function<void(const TestOfFile&)>& read,
                const std::function<void(const lab::BadInput&)>& on_fault);

}  // namespace triax::study
