// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::lab::test {

/// A small complete programme; `stages` replaces its last stage.
inline std::string programme_text(const std::string& stages = R"(
[[stages]]
name = "undrained compression"
role = "shear"
drainage = "closed"
axial = "displacement"
axial_rate_mm_per_min = 1.0
end = [{quantity = "axial_strain_pct", above = 1.0}]
)",
                                  const std::string& rig = "back_pressure_kPa = 300.0\n",
                                  const std::string& void_ratio = "1.086") {
  return R"([test]
name = "small"
type = "ICU"
seed = 3
scan_interval_s = 1.0
[specimen]
material = "sanisand/S28-general"
height_mm = 140.0
diameter_mm = 70.0
void_ratio = )" +
         void_ratio + "\ninitial_effective_stress_kPa = 100.0\n[rig]\n" + rig + stages;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

}  // namespace triax::lab::test
