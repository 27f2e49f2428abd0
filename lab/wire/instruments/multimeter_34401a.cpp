// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/instruments/multimeter_34401a.hpp"

#include <fmt/format.h>

#include <cmath>

namespace triax::lab {

std::string meter_number(double value) {
  return std::isfinite(value) ? fmt::format("{:+.8E}", value) : "+9.90000000E+37";
}

Multimeter34401A::Multimeter34401A(const WireDevice& device) : device_(device) {
  add_common_commands(table_, device);
  table_.add("CONFigure[:VOLTage][:DC]", 2, "DC volts: range, resolution in V",
             [this](ScpiCall& call) { configure(call); });
  table_.add("CONFigure?", 0, "what is measured, range, resolution", [this](ScpiCall& call) {
    call.reply = fmt::format("\"VOLT {:+.6E},{:+.6E}\"", range_V_, resolution_V_);
  });
  table_.add("MEASure[:VOLTage][:DC]?", 2, "a reading of DC volts", [this](ScpiCall& call) {
    configure(call);
    call.reply = meter_number(volts());
  });
  table_.add("[SENSe:]FUNCtion?", 0, "what is measured",
             [](ScpiCall& call) { call.reply = "\"VOLT\""; });
  table_.add("READ?", 0, "a new reading, V",
             [this](ScpiCall& call) { call.reply = meter_number(volts()); });
  table_.add("INITiate[:IMMediate]", 0, "takes a reading into the memory",
             [this](ScpiCall&) { taken_V_ = volts(); });
  table_.add("FETCh?", 0, "the reading in the memory, V", [this](ScpiCall& call) {
    if (!taken_V_) throw ScpiError(-230, "no reading in the memory; send INIT first");
    call.reply = meter_number(*taken_V_);
  });
  table_.add("DATA:POINts?", 0, "readings in the memory",
             [this](ScpiCall& call) { call.reply = taken_V_ ? "+1" : "+0"; });
  table_.add("ABORt", 0, "ends a measurement: none is under way", [](ScpiCall&) {});
  for (const char* who : {"SYSTem:REMote", "SYSTem:LOCal"})
    table_.add(who, 0, "front panel off or on: there is none", [](ScpiCall&) {});
}

double Multimeter34401A::volts() const { return device_.points.front().read(); }

void Multimeter34401A::configure(ScpiCall& call) {
  const auto given = [&call](double usual) {
    return call.parameters.more() ? call.parameters.number("V") : usual;
  };
  const double range_V = given(10);
  if (!(range_V > 0 && range_V <= 1000)) throw ScpiError(-222, "ranges are 0.1 to 1000 V");
  double of_meter_V = 0.1;
  while (of_meter_V < range_V * (1 - 1e-9)) of_meter_V *= 10;
  resolution_V_ = given(of_meter_V * 1e-6);
  range_V_ = of_meter_V;
}

}  // namespace triax::lab
