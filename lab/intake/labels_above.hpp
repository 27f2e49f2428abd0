// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "lab/intake/names/labels.hpp"
#include "lab/intake/text/structure.hpp"

namespace triax::lab {

/// Values of the lines above a table, each once:
/// - Two values of one number make both ambiguous.
/// - The diameter follows from a stated area, or from height and volume, if it is not stated.
/// - The type of the test is that of a title line if no label states it.
/// - `beside` are lines of other worksheets (CSV): their labels, with line 0, count if the lines
///   above the table do not have them.
std::vector<LabelValue> labels_above(const std::vector<std::string>& lines, Separator separator,
                                     const std::vector<std::string>& beside = {});
/// The same of a block of a table (from 1; 0: of the only one), with its title. Values in the
/// columns of another block are left out, and also those in the columns of the first block if
/// another block has the same label.
std::vector<LabelValue> labels_above(const TableStructure& structure, std::size_t block);

}  // namespace triax::lab
