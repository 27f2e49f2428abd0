// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The order of rows and the number of tests that they are of.
#include <cstddef>
#include <string>
#include <vector>

#include "lab/intake/meaning.hpp"
#include "lab/intake/table_columns.hpp"

namespace triax::lab {

struct RowCourse {
  bool is_reversed = false;                 ///< the last reading is in the first row
  std::vector<std::size_t> test_begins{0};  ///< rows of the sample with which a test begins
  std::size_t test_column = 0;              ///< position of the column that names them; 0: none
};

/// True if the heading is a name or number of tests, specimens or samples ("Probe Nr.").
bool names_tests(const std::string& heading);

/// The order by the times, clocks and numbers of rows, else by the strain (RowDirection). The tests
/// by a column that names them, each in one run of rows, else by restarts (RestartFinder). Stages
/// of one test are not separated.
RowCourse find_course(const TableColumns& table, const Meaning& meaning);

}  // namespace triax::lab
