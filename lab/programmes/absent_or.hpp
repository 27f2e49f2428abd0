// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace triax::lab {

class TomlTable;

/// A number that is 0, which stands for absent (and so can take back what a set of instruments
/// gives), or from `smallest` to `largest`; nothing where the key is not there. Throws BadInput.
std::optional<double> absent_or(const TomlTable& table, const std::string& key, double smallest,
                                double largest);

}  // namespace triax::lab
