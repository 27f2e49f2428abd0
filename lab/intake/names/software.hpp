// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The software that wrote a file, and the meaning of its columns.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/results/record_header.hpp"

namespace triax::lab {

/// A column that needs more than its name to be understood.
struct SoftwareColumn {
  std::string heading;      ///< without a unit
  std::optional<int> sign;  ///< 1 or -1
  double factor = 1;
  std::string unit;      ///< of the file, if its heading is wrong or has none; "-": plain number
  std::string quantity;  ///< of the lexicon; empty: as named
  std::string note;
};

/// Fingerprint of a program, from lab/intake/lexicon/software.toml.
struct Software {
  std::string name;
  std::string note;
  std::vector<std::string> headings;  ///< all are in the file
  std::vector<std::string> any;       ///< and one of these
  std::string first_cell;             ///< the file begins so
  std::string contains;               ///< one of its first lines contains this text
  std::string stage_column;
  Drainage drainage = Drainage::unknown;
  bool strain_is_logarithmic = false;
  bool holds_readings = true;  ///< false: results of many tests
  std::vector<SoftwareColumn> columns;
  std::vector<SoftwareColumn> labels;  ///< `heading` is the label
};

/// The software that wrote a file with these headings (UTF-8, as written). `head` is the text of
/// its first lines. The fingerprint with most headings counts. Null if none fits. The facts are
/// evidence for a proposal: physics over all rows is stronger.
const Software* find_software(const std::vector<std::string>& headings, std::string_view head = {});

/// The column with this heading, with or without its unit; null if there is no entry.
const SoftwareColumn* find_software_column(const Software& software, std::string_view heading);

}  // namespace triax::lab
