// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace triax::lab {

/// A path's stretch as a table of cumulative values: one column a condition.
struct PathTable {
  std::vector<std::string> headings;
  std::vector<std::vector<double>> rows;  ///< each as long as `headings`
  std::vector<std::int64_t> lines;        ///< of the rows, in the file
};

/// Reads a CSV of comma-separated plain numbers with one line of headings; lines that are blank or
/// begin with # are left out. Throws BadInput (file:line).
PathTable read_path_table(const std::string& path);

}  // namespace triax::lab
