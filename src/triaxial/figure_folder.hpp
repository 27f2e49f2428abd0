// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The figures of a report as files of their own.
#include <string>
#include <vector>

#include "src/output/file_names.hpp"
#include "src/plot/drawing.hpp"
#include "src/study/triaxial/collapse_increment.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/triaxial/sheet/sheet_test.hpp"

namespace triax::src {

/// Writes into `folder`, which is made where it does not exist, of each figure an SVG, a PNG and a
/// PDF:
///
///   TEST_stress_path, TEST_history, TEST_onset, TEST_alarm    of each test
///   TEST_consolidation, TEST_q, TEST_u, TEST_p or TEST_volume, TEST_eta, TEST_path,
///   TEST_void_ratio    those of its sheet
///   TYPE_stress_paths, TYPE_shear_curves, TYPE_strains    of all tests of a type (ICU, CSD...)
///   collapse_points, stress_increments                    of all tests
///
/// TEST and TYPE are their names in small letters, what is no letter and no digit being '_', and
/// distinct as FileNames makes them: of two tests with one name the second has its id behind it. A
/// figure without data is left out. All throw lab::BadInput, lab::WorkFailed.
class FigureFolder {
 public:
  explicit FigureFolder(std::string folder);
  /// The figures of a test. What is kept of it for those that compare tests is little
  /// (keep_few_states).
  void add(const study::TestResult& test);
  void add(const SheetTest& test);
  /// The figures that compare the tests added.
  void finish(const std::vector<study::CollapseIncrement>& increments);
  /// The prefixes written.
  const std::vector<std::string>& written() const { return written_; }

 private:
  std::string name_of(const db::StoredTest& test);
  void write(const std::string& name, const Drawing& drawing);
  void add_as(const std::string& name, const study::TestResult& test);
  void write_types();

  std::string folder_;
  FileNames names_;
  std::vector<study::TestResult> compared_;
  std::vector<std::string> written_;
};

}  // namespace triax::src
