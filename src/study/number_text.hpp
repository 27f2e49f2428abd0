// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace triax::study {

/// A plain number with so many decimals; "–" where it is unknown, never "-0.00".
std::string number_text(std::optional<double> value, int decimals);

}  // namespace triax::study
