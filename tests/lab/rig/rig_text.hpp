// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

// Short programmes for tests of the virtual rig, and their readings.
namespace triax::lab::test {

inline const std::string kIdealFrame = "[rig.frame]\nmoving_mass_kg = 0.0\n";

/// `rig` and `stages` as text; one tick a scan; consolidated to p' = 100 kPa, u = 300 kPa.
inline Programme rig_programme(const std::string& stages, const std::string& rig = kIdealFrame,
                               double scan_s = 0.25,
                               const std::string& material = "inl2/S28-general") {
  return read_programme("[test]\nname = \"t\"\ntype = \"ICU\"\nseed = 1\nscan_interval_s = " +
                            std::to_string(scan_s) + "\n[specimen]\nmaterial = \"" + material +
                            "\"\nheight_mm = 140.0\ndiameter_mm = 70.0\nvoid_ratio = 1.086\n"
                            "initial_effective_stress_kPa = 100.0\n[rig]\nback_pressure_kPa = "
                            "300.0\n" +
                            rig + stages,
                        "p.toml");
}

/// `keys` are lines, `end` one condition.
inline std::string stage_text(const std::string& role, const std::string& drainage,
                              const std::string& axial, const std::string& keys,
                              const std::string& end) {
  return "[[stages]]\nname = \"" + axial + "\"\nrole = \"" + role + "\"\ndrainage = \"" + drainage +
         "\"\naxial = \"" + axial + "\"\n" + keys + "\nend = [{quantity = " + end + "}]\n";
}

inline std::string shear_stage(const std::string& drainage, const std::string& axial,
                               const std::string& keys, const std::string& end) {
  return stage_text("shear", drainage, axial, keys, end);
}

inline std::vector<Reading> all_readings(BackEnd& rig) {
  std::vector<Reading> readings;
  for (Reading reading; rig.next(reading);) readings.push_back(reading);
  return readings;
}

/// The readings of a stage, by its number.
inline std::vector<Reading> of_stage(const std::vector<Reading>& readings, int stage) {
  std::vector<Reading> some;
  for (const Reading& reading : readings)
    if (reading.stage == stage) some.push_back(reading);
  return some;
}

}  // namespace triax::lab::test
