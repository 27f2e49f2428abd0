// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The text of a table of results (element dataValues): tuples of cells.
#include <cstdint>
#include <string_view>
#include <vector>

#include "lab/diggs/diggs_document.hpp"

namespace triax::lab {

struct DiggsTuple {
  std::int64_t line = 0;                ///< of the file
  std::vector<std::string_view> cells;  ///< as many as the set has properties
};

/// Splits the values of a set, which must outlive the tuples. A separator that is a space means
/// any spaces and line ends; a comma may be followed by spaces. Throws BadInput with the line for a
/// tuple with another number of cells than the set has properties.
std::vector<DiggsTuple> split_data_values(const DiggsResultSet& set, const std::string& file);

}  // namespace triax::lab
