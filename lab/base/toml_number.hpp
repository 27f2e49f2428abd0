// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::lab {

/// A TOML float that is read back to the bit; a whole number needs a point.
std::string toml_number(double value);

}  // namespace triax::lab
