// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "lab/programmes/programme.hpp"

namespace triax::lab {

class TomlTable;

/// Reads the [[operator]] tables: what somebody does at the panel, in the order of time; a resume
/// needs a hold before it, a hold something that ends it, nothing comes after an abort. Throws
/// BadInput.
std::vector<OperatorAction> read_operator(const std::vector<TomlTable>& tables);

}  // namespace triax::lab
