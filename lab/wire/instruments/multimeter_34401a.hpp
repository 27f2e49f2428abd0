// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/wire/scpi/table.hpp"

namespace triax::lab {

/// A bench multimeter's 34401A tree over one point of a device, its input in V: enough of it for
/// those who only know such a meter (sigrok's scpi-dmm among them). It measures DC volts; a reading
/// is taken when it is asked for (READ?, MEASure?) or at INITiate, which FETCh? gives. No value now
/// is an open input: overload, 9.9E37.
class Multimeter34401A {
 public:
  /// The device outlives it, and its first point can be read. Its identity must name the model.
  explicit Multimeter34401A(const WireDevice& device);
  Multimeter34401A(const Multimeter34401A&) = delete;
  Multimeter34401A& operator=(const Multimeter34401A&) = delete;

  const ScpiTable& table() const { return table_; }
  /// As the model says who it is.
  static constexpr const char* kIdentity = "HEWLETT-PACKARD,34401A,0,10-5-2";

 private:
  double volts() const;
  void configure(ScpiCall& call);

  const WireDevice& device_;
  ScpiTable table_;
  double range_V_ = 10, resolution_V_ = 1e-5;
  std::optional<double> taken_V_;  ///< what INITiate took
};

/// "+1.23456789E+00": nine digits, as these instruments write readings.
std::string meter_number(double value);

}  // namespace triax::lab
