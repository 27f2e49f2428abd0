// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands behind a line on the instrument's side. A device knows no protocol: it is a list of
// named values that can be asked for or set; SCPI commands and Modbus registers name the same ones
// (personality.hpp).
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// A value that the device does not take now: outside its limits (SCPI −222, Modbus exception 3),
/// or not in the state it is in (SCPI −221, Modbus exception 4). The message names the limits.
class Refused : public std::runtime_error {
 public:
  enum class Why { out_of_range, conflict };
  Refused(Why why, const std::string& message) : std::runtime_error(message), why_(why) {}
  Why why() const { return why_; }

 private:
  Why why_;
};

/// One value, in the unit of the field that its name ends with: "target_kPa", "valve_open".
struct Point {
  std::string name;
  std::function<double()> read;       ///< empty: it cannot be asked for; NaN: no value now
  std::function<void(double)> write;  ///< empty: it cannot be set; throws Refused
};

struct WireDevice {
  std::string name;      ///< as the rig's file calls it
  std::string identity;  ///< answer to *IDN?: maker, model, serial number, version
  std::vector<Point> points;
  /// Called at every message that asks or sets anything: for a watchdog. May be empty.
  std::function<void()> heard;
  /// *RST: back to what it was when switched on, without a movement. May be empty.
  std::function<void()> reset;

  const Point* find(std::string_view point) const {
    for (const Point& p : points)
      if (p.name == point) return &p;
    return nullptr;
  }
};

}  // namespace triax::lab
