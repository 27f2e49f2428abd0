// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A device of two points and a client's talk with it.
#include "lab/wire/scpi/scpi_conversation.hpp"

namespace triax::wire_tests {

struct AskedDevice {
  double pressure_kPa = 100.125, target_kPa = 100;
  int heard = 0, resets = 0;
  lab::WireDevice device{.name = "cell",
                         .identity = "triax,pressure controller,1,0",
                         .points = {{"pressure_kPa", [this] { return pressure_kPa; }, nullptr},
                                    {"target_kPa", [this] { return target_kPa; },
                                     [this](double value) {
                                       if (value > 1000)
                                         throw lab::Refused(lab::Refused::Why::out_of_range,
                                                            "target_kPa is 0 to 1000");
                                       if (value < 0)
                                         throw lab::Refused(lab::Refused::Why::conflict,
                                                            "the \"valve\" is shut");
                                       target_kPa = value;
                                     }}},
                         .heard = [this] { ++heard; },
                         .reset = [this] { ++resets; }};
  std::vector<lab::ScpiHeader> headers{
      {"pressure_kPa", "MEASure:PRESsure", true, false, "pressure, kPa"},
      {"target_kPa", "[SOURce:]PRESsure:TARGet", true, true, "target, kPa"}};
  lab::ScpiTable table = lab::scpi_table_of(device, headers);
  lab::ScpiConversation client{table, device};

  /// What comes back, without its line feed.
  std::string ask(const std::string& message) {
    std::string reply;
    client.take(message + "\n", reply);
    if (reply.ends_with('\n')) reply.pop_back();
    return reply;
  }
  /// The first error that a message leaves; the others are cleared.
  std::string error_of(const std::string& message) {
    ask("*CLS");
    ask(message);
    const std::string error = ask("SYST:ERR?");
    ask("*CLS");
    return error;
  }
};

}  // namespace triax::wire_tests
