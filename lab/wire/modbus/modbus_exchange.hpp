// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Modbus on the controller's side: one request and the check of its answer.
#include "lab/wire/exchange.hpp"
#include "lab/wire/modbus/frames.hpp"
#include "lab/wire/modbus/pdu.hpp"

namespace triax::lab {

/// Where a request goes.
struct ModbusPath {
  ModbusFraming framing = ModbusFraming::tcp;
  int unit = 1;
  unsigned transaction = 0;  ///< of TCP: what its answer repeats, so that a late one is not taken
};

/// `data` reads what stands in the answer behind function and length; empty for a write, whose
/// answer must repeat address and count (or value). Any other transaction, unit or function, a
/// wrong length or check sum and an exception of the instrument are Malformed.
Exchange modbus_exchange(const ModbusPath& path, const std::string& request,
                         std::function<std::vector<double>(std::string_view data)> data = {});
/// The same for registers that hold a text, two characters each.
Exchange modbus_text_exchange(const ModbusPath& path, int address, int registers);

}  // namespace triax::lab
