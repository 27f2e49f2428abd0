// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The truth of a simulation as TOML, below the rows of a record: [truth] and [[truth.run_aways]].
#include <string>

#include "lab/base/toml_reader.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Reads the table [truth]. Throws BadInput for unknown keys, wrong types, a run-away without a
/// start, values that are finite in no unit.
Truth read_truth(const TomlTable& table);

/// Known values only; reading it back gives the same values.
std::string truth_toml(const Truth& truth);

}  // namespace triax::lab
