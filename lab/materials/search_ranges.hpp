// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the parameters of a law are looked for: the table [search] of a parameter file.
//
//   [search]
//   critical_friction_angle_deg = [25.0, 40.0]
//   granulate_hardness_kPa = [1.0e5, 1.0e8]
//   "properties.3" = [0.1, 0.6]               # the third number of a list, as of a UMAT
//
//   [prior]
//   critical_friction_angle_deg = [33.1, 0.4] # known beforehand: value and standard error
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/toml_reader.hpp"

namespace triax::lab {

struct SearchRange {
  std::string key;  ///< of the parameter; of a number in a list "properties.3"
  double low = 0, high = 0;
  bool in_logarithm = false;  ///< steps are ratios: both above 0 and high beyond 20 low
  struct Prior {
    double value = 0, error = 0;
  };
  std::optional<Prior> prior;
};

/// Whether a range between these is searched in ratios.
bool is_of_ratios(double low, double high);

/// [search] and [prior] of a document, whose keys become known by it; empty where it has neither.
/// Throws BadInput.
std::vector<SearchRange> read_search(const TomlTable& root);
/// The same of the text of a file.
std::vector<SearchRange> read_search(std::string_view toml_text, const std::string& file);

/// What ships with the law; empty for a law without.
std::vector<SearchRange> shipped_search(std::string_view law);

}  // namespace triax::lab
