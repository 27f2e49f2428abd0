// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace triax::lab {

/// One value of an instrument: by its name, or by the number of its channel; neither: the only one.
struct AskedValue {
  std::string point;  ///< "pressure_kPa"
  std::optional<int> at;
};

}  // namespace triax::lab
