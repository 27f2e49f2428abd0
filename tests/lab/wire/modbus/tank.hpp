// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A device of the tests: what is written to it, in order, and what it says.
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lab/wire/personality.hpp"
#include "lab/wire/wire_device.hpp"

struct Tank {
  std::map<std::string, double> values;
  std::vector<std::pair<std::string, double>> written;
  int heard = 0;
  triax::lab::WireDevice device;

  explicit Tank(const triax::lab::Personality& personality, double limit = 1e9) {
    device.identity = personality.identity.begins + ",1,1.0";
    device.heard = [this] { ++heard; };
    for (const auto& point : personality.points) {
      triax::lab::Point made{point.name, {}, {}};
      if (point.readable) made.read = [this, name = point.name] { return values[name]; };
      if (point.writable)
        made.write = [this, limit, name = point.name](double value) {
          using triax::lab::Refused;
          if (value > limit) throw Refused(Refused::Why::out_of_range, "limit");
          if (value < 0) throw Refused(Refused::Why::conflict, "state");
          written.emplace_back(name, value);
          values[name] = value;
        };
      device.points.push_back(made);
    }
  }
  Tank(const Tank&) = delete;
};

/// Values at 0, 2 (floats), 4 (uint16), 10 (rw float), 12 (rw float), 14 (rw uint16); 100 and 110
/// scaled; coils 19 to 28 rw.
inline triax::lab::Personality tank_personality() {
  std::string text = R"(
title = "tank"
protocol = ["scpi", "modbus"]
[identity]
ask = "*IDN?"
begins = "triax,tank"
register = 200
registers = 16
[line]
compound = true
set_check = "SYSTem:ERRor[:NEXT]?"
[points.level_mm]
scpi = "MEASure:LEVel"
modbus = { register = 0, scaled = { register = 100, factor = 0.5 } }
[points.force_N]
scpi = "MEASure:FORCe"
modbus = { register = 2 }
[points.state]
scpi = "STATus"
modbus = { register = 4, form = "uint16" }
[points.target_mm]
access = "rw"
scpi = "SOURce:TARGet"
modbus = { register = 10, scaled = { register = 110, factor = 0.5 } }
[points.rate_mm_per_s]
access = "rw"
scpi = "SOURce:RATE"
modbus = { register = 12 }
[points.mode]
access = "rw"
scpi = "SOURce:MODE"
modbus = { register = 14, form = "uint16" }
)";
  for (int i = 19; i < 29; ++i)
    text += "[points.coil_" + std::to_string(i) +
            "]\naccess = \"rw\"\nmodbus = { coil = " + std::to_string(i) + " }\n";
  return triax::lab::parse_personality(text, "tank.toml");
}
