// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "lab/wire/scpi/table.hpp"

namespace triax::lab {
namespace {

using GroupOf = ScpiStatus::Group ScpiStatus::*;

void answer_number(ScpiCall& call, std::size_t value) { call.reply = std::to_string(value); }

void add_events(ScpiTable& table) {
  table.add("*CLS", 0, "clears events and errors", [](ScpiCall& call) { call.status.clear(); });
  table.add("*ESE", 1, "standard events that count", [](ScpiCall& call) {
    call.status.standard.enable = static_cast<unsigned>(call.parameters.integer(0, 255));
  });
  table.add("*ESE?", 0, "standard events that count",
            [](ScpiCall& call) { answer_number(call, call.status.standard.enable); });
  table.add("*ESR?", 0, "standard events; asking clears them",
            [](ScpiCall& call) { answer_number(call, call.status.standard.take_event()); });
  table.add("*SRE", 1, "bits of the status byte that ask for service", [](ScpiCall& call) {
    const int bits = call.parameters.integer(0, 255);
    call.status.request_enable = static_cast<unsigned>(bits) & ~ScpiStatus::kMaster;
  });
  table.add("*SRE?", 0, "bits of the status byte that ask for service",
            [](ScpiCall& call) { answer_number(call, call.status.request_enable); });
  table.add("*STB?", 0, "status byte",
            [](ScpiCall& call) { answer_number(call, call.status.status_byte(call.message)); });
  table.add("*OPC", 0, "sets the first standard event: nothing is under way",
            [](ScpiCall& call) { call.status.set_event(ScpiStatus::kOperationComplete); });
  table.add("*OPC?", 0, "1: nothing is under way", [](ScpiCall& call) { call.reply = "1"; });
  table.add("*WAI", 0, "waits for what is under way: nothing is", [](ScpiCall&) {});
}

void add_group(ScpiTable& table, const std::string& node, const std::string& name, GroupOf group) {
  table.add("STATus:" + node + "[:EVENt]?", 0, name + " events; asking clears them",
            [group](ScpiCall& call) { answer_number(call, (call.status.*group).take_event()); });
  table.add("STATus:" + node + ":CONDition?", 0, name + " condition",
            [group](ScpiCall& call) { answer_number(call, (call.status.*group).condition); });
  table.add("STATus:" + node + ":ENABle", 1, name + " events that count", [group](ScpiCall& call) {
    (call.status.*group).enable = static_cast<unsigned>(call.parameters.integer(0, 65535));
  });
  table.add("STATus:" + node + ":ENABle?", 0, name + " events that count",
            [group](ScpiCall& call) { answer_number(call, (call.status.*group).enable); });
}

}  // namespace

void add_common_commands(ScpiTable& table, const WireDevice& device) {
  table.add(
      "*IDN?", 0, "maker, model, serial number, version",
      [&device](ScpiCall& call) { call.reply = device.identity; }, true);
  add_events(table);
  table.add("*RST", 0, "settings as when switched on; nothing moves", [&device](ScpiCall&) {
    if (device.reset) device.reset();
  });
  table.add("*TST?", 0, "0: well", [](ScpiCall& call) { call.reply = "0"; });
  table.add("SYSTem:ERRor[:NEXT]?", 0, "the oldest error, which is taken away",
            [](ScpiCall& call) { call.reply = call.status.take_error(); });
  table.add("SYSTem:ERRor:COUNt?", 0, "errors that wait",
            [](ScpiCall& call) { answer_number(call, call.status.errors()); });
  table.add("SYSTem:VERSion?", 0, "version of SCPI", [](ScpiCall& call) { call.reply = "1999.0"; });
  add_group(table, "QUEStionable", "questionable", &ScpiStatus::questionable);
  add_group(table, "OPERation", "operation", &ScpiStatus::operation);
  table.add("STATus:PRESet", 0, "no questionable or operation event counts", [](ScpiCall& call) {
    call.status.questionable.enable = call.status.operation.enable = 0;
  });
}

}  // namespace triax::lab
