// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

// A small path that the tests change in single places.
namespace triax::lab::test {

inline const std::string kPath = R"([path]
name = "small"
material = "sanisand/S28-general"

[start]
p_eff_kPa = 100.0
void_ratio = 1.0

[[segments]]
name = "compression"
drainage = "undrained"
conditions = ["axial_strain = 0.02", "radial_stress_kPa = 0"]
)";

/// The text with the first `what` replaced.
inline std::string with(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

}  // namespace triax::lab::test
