// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::test {

/// A programme of grains that takes a second.
inline const std::string kSmallGrains = R"([run]
name = "small"

[specimen]
grains = 200
seed = 3
pressure_kPa = 100.0
compaction_friction_deg = 20.0

[contact]
friction_angle_deg = 30.0

[[stages]]
name = "isotropic"
action = "isotropic"
pressure_kPa = 120.0

[[stages]]
name = "drained"
action = "drained"
radial_stress_kPa = 120.0
strain_rate_per_s = 0.5
end_axial_strain_pct = 0.5
marks = [{name = "a point", quantity = "stress_ratio", value = 0.2}]

[[stages]]
name = "at rest"
action = "rest"
from = "a point"
save = true

[[stages]]
name = "probes"
action = "probes"
directions = 4

[[stages]]
name = "path"
action = "strain_path"
from = "isotropic"
strain_path_R = 0.9
strain_rate_per_s = 0.5
end_axial_strain_pct = 0.2

[[stages]]
name = "held"
action = "equilibrium"
strain_path_R = 0.9

[[stages]]
name = "hit"
action = "perturbation"
strain_path_R = 0.9
load_step_Pa = 100.0
longest_s = 0.02
)";

/// The text with its first `from` replaced. `from` has to be in it.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

}  // namespace triax::test
