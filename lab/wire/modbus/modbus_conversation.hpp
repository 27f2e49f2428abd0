// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Modbus on the instrument's side: devices behind one line, each by its unit.
#include <vector>

#include "lab/wire/conversation.hpp"
#include "lab/wire/modbus/frames.hpp"
#include "lab/wire/modbus/register_map.hpp"

namespace triax::lab {

/// Map and device live longer than any conversation.
struct ModbusUnit {
  int number = 1;  ///< 1 to 247
  const RegisterMap* map = nullptr;
  const WireDevice* device = nullptr;
};

/// A wrong unit is answered by exception 11, as a gateway does. Units 0 and 255 mean the device
/// itself where there is one only. What is no Modbus (protocol, length) ends the conversation.
class ModbusTcpConversation : public Conversation {
 public:
  explicit ModbusTcpConversation(std::vector<ModbusUnit> units) : units_(std::move(units)) {}
  void take(std::string_view bytes, std::string& reply) override;
  bool over() const override { return over_; }

 private:
  std::string answer(int unit, std::string_view request) const;
  std::vector<ModbusUnit> units_;
  std::string kept_;  // less than one frame
  bool over_ = false;
};

/// A frame whose length its function tells is answered at once, any other after a silence. Wrong
/// units and wrong check sums are met with silence; what is written to unit 0 reaches all,
/// unanswered.
class ModbusRtuConversation : public Conversation {
 public:
  /// An operating system hands bytes over in pieces and late: the silence that drops what came is
  /// 20 ms at least.
  ModbusRtuConversation(std::vector<ModbusUnit> units, int baud);
  void take(std::string_view bytes, std::string& reply) override;
  std::optional<double> waits_s() const override;
  void silent(std::string& reply) override;

 private:
  void answer(std::string_view frame, std::string& reply) const;
  std::vector<ModbusUnit> units_;
  double silence_s_;
  std::string kept_;
  bool lost_ = false;  // what came is no frame: waits for a silence
};

}  // namespace triax::lab
