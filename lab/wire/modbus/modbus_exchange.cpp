// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/modbus_exchange.hpp"

#include <fmt/format.h>

namespace triax::lab {
namespace {

/// Throws Malformed unless what came so far begins like the answer; unit and function.
void check_unit(const ModbusPath& path, unsigned function, std::string_view from_unit) {
  const auto unit = static_cast<int>(byte_at(from_unit, 0));
  if (unit != path.unit)
    throw Malformed(fmt::format("a response from unit {} to a query to unit {}", unit, path.unit));
  if (from_unit.size() > 1 && (byte_at(from_unit, 1) & ~kExceptionBit) != function)
    throw Malformed(fmt::format("a response to function {} instead of {}",
                                byte_at(from_unit, 1) & ~kExceptionBit, function));
}

std::size_t whole_tcp(const ModbusPath& path, unsigned function, std::string_view received) {
  if (received.size() < kTcpHeader) return 0;
  if (word_at(received, 0) != path.transaction)
    throw Malformed(fmt::format("a response to query {} instead of {}", word_at(received, 0),
                                path.transaction));
  if (word_at(received, 2) != 0) throw Malformed("not Modbus: protocol is not 0");
  const std::size_t length = word_at(received, 4);
  if (length < 3 || length > kLongestPdu + 1)
    throw Malformed(fmt::format("not Modbus: a length of {}", length));
  check_unit(path, function, received.substr(kTcpHeader - 1));
  const std::size_t whole = kTcpHeader - 1 + length;
  if (received.size() < whole) return 0;
  if (answer_length(received.substr(kTcpHeader, length - 1)) != length - 1)
    throw Malformed("a length that does not fit the response");
  return whole;
}

std::size_t whole_rtu(const ModbusPath& path, unsigned function, std::string_view received) {
  if (received.empty()) return 0;
  check_unit(path, function, received);
  const std::size_t length = answer_length(received.substr(1));
  const std::size_t whole = length + kRtuAround;
  if (length == 0 || received.size() < whole) return 0;
  if (!crc_holds(received.substr(0, whole))) throw Malformed("a wrong checksum");
  return whole;
}

/// What is said behind function and length; throws for an exception and for a write that was not
/// repeated.
std::string_view data_of(const ModbusPath& path, std::string_view request,
                         std::string_view answer) {
  const bool tcp = path.framing == ModbusFraming::tcp;
  const auto pdu = tcp ? answer.substr(kTcpHeader) : answer.substr(1, answer.size() - kRtuAround);
  if ((byte_at(pdu, 0) & kExceptionBit) != 0) throw Malformed(exception_text(byte_at(pdu, 1)));
  if (byte_at(request, 0) <= 4) return pdu.substr(2);
  if (pdu != request.substr(0, 5)) throw Malformed("a response that confirms another setting");
  return {};
}

Exchange asked(const ModbusPath& path, const std::string& request) {
  Exchange exchange;
  const bool tcp = path.framing == ModbusFraming::tcp;
  exchange.request =
      tcp ? tcp_frame(path.transaction, path.unit, request) : rtu_frame(path.unit, request);
  exchange.whole = [path, tcp, function = byte_at(request, 0)](std::string_view received) {
    return tcp ? whole_tcp(path, function, received) : whole_rtu(path, function, received);
  };
  return exchange;
}

}  // namespace

Exchange modbus_exchange(const ModbusPath& path, const std::string& request,
                         std::function<std::vector<double>(std::string_view)> data) {
  Exchange exchange = asked(path, request);
  exchange.values = [path, request, data = std::move(data)](std::string_view answer) {
    const auto said = data_of(path, request, answer);
    return data ? data(said) : std::vector<double>();
  };
  return exchange;
}

Exchange modbus_text_exchange(const ModbusPath& path, int address, int registers) {
  const auto request = read_request(ModbusFunction::read_input_registers, address, registers);
  Exchange exchange = asked(path, request);
  exchange.text = [path, request, registers](std::string_view answer) {
    const auto said = data_of(path, request, answer);
    if (said.size() != 2 * static_cast<std::size_t>(registers))
      throw Malformed("a wrong number of registers");
    return std::string(said.substr(0, said.find('\0')));
  };
  return exchange;
}

}  // namespace triax::lab
