// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A device's values by their registers: functions 3 and 4 read the same ones, 1 and 2 the same
// bits, so that it does not matter which a client asks for. Only what can be written has a use for
// 5, 6, 15 and 16.
#include <string>
#include <string_view>
#include <vector>

#include "lab/wire/modbus/pdu.hpp"
#include "lab/wire/personality.hpp"
#include "lab/wire/wire_device.hpp"

namespace triax::lab {

class RegisterMap {
 public:
  struct Spot {
    std::string point;  ///< empty: two characters of the identity, `place.address` on
    PointRegister place;
    bool readable = true, writable = false;
  };
  explicit RegisterMap(const Personality& personality);

  /// The value whose register or bit has this address; null: none.
  const Spot* find(bool bit, int address) const;
  int identity_from() const { return identity_from_; }

 private:
  std::vector<Spot> registers_, bits_;  // in order of address
  int identity_from_ = 0;
};

/// The answer to one request, an exception among them; never throws for what it holds.
///  - 1: a function other than 1 to 6, 15 and 16
///  - 2: an address that has no value, that the device has not, or that cannot be written
///  - 3: a wrong count or length, a number that is none, half a float written, a value that the
///       device refuses
///  - 4: the device does not take it in its state
/// All of a request is checked before any of it is applied. Its values then reach the device in
/// the order of their addresses, a float at once; what a refusal cuts off stays applied up to it.
std::string answer_modbus(const RegisterMap& map, const WireDevice& device,
                          std::string_view request);

}  // namespace triax::lab
