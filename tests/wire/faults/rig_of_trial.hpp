// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::lab::test {

/// By SCPI the scanner reads all but what only the controllers count; by Modbus frame and
/// controllers read what they can, and the scanner the rest.
inline std::string rig_of_trial(bool modbus) {
  const auto channel = [](const std::string& quantity, const std::string& at,
                          const std::string& unit, const std::string& gain) {
    return "[[instruments.channels]]\nquantity = \"" + quantity + "\"\nat = \"" + at +
           "\"\nunit = \"" + unit + "\"\ncalibration = {gain = " + gain +
           ", date = \"2026-03-17\"}\n";
  };
  const std::string link = modbus ? "modbus-tcp://127.0.0.1:0/3" : "tcp://127.0.0.1:0";
  const auto drive = [&link](const std::string& name, const std::string& personality) {
    return "[[instruments]]\nname = \"" + name + "\"\nlink = \"" + link + "\"\npersonality = \"" +
           personality + "\"\nrole = \"" + name + "\"\n";
  };
  const std::string displacement = modbus ? "" : channel("axial_displacement", "101", "mm", "5.0"),
                    force = modbus ? "" : channel("axial_force", "102", "N", "1000.0"),
                    cell = modbus ? "" : channel("cell_pressure", "103", "kPa", "200.0");
  return "[rig]\nname = \"trial\"\n[plant]\nprogramme = \"p.toml\"\ncontrol = "
         "\"tcp://127.0.0.1:0\"\n[[instruments]]\nname = \"scanner\"\nlink = "
         "\"tcp://127.0.0.1:0\"\npersonality = \"34970A\"\n" +
         displacement + force + cell + channel("pore_pressure", "105", "kPa", "-100.0") +
         drive("frame", "triax-frame") +
         (modbus ? channel("axial_displacement", "displacement_mm", "mm", "1.0") +
                       channel("axial_force", "force_N", "N", "1.0")
                 : "") +
         drive("cell", "triax-controller") +
         (modbus ? channel("cell_pressure", "pressure_kPa", "kPa", "1.0") : "") +
         channel("cell_volume", "volume_mm3", "mm3", "1.0") + drive("back", "triax-controller") +
         channel("back_pressure", "pressure_kPa", "kPa", "1.0") +
         channel("back_volume", "volume_mm3", "mm3", "1.0");
}

/// The instrument that measures it.
inline std::string instrument_of(const std::string& quantity, bool modbus) {
  if (quantity == "pore_pressure") return "scanner";
  if (quantity == "cell_volume") return "cell";
  if (quantity == "back_pressure" || quantity == "back_volume") return "back";
  if (!modbus) return "scanner";
  return quantity == "cell_pressure" ? "cell" : "frame";
}

}  // namespace triax::lab::test
