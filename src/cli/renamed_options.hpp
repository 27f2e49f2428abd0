// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace triax::src {

/// Arguments of the program (without its own name) in which options that had another name once, as
/// --threads of domain, have that of today. Neither help nor completion knows the old ones.
[[nodiscard]] std::vector<std::string> with_names_of_today(std::vector<std::string> arguments);

}  // namespace triax::src
