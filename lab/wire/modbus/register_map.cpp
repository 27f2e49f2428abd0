// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/modbus/register_map.hpp"

#include <algorithm>

namespace triax::lab {

RegisterMap::RegisterMap(const Personality& personality) {
  for (const auto& point : personality.points)
    for (const auto& place : point.registers)
      (place.is_bit() ? bits_ : registers_)
          .push_back({point.name, place, point.readable, point.writable});
  if (personality.identity.register_) identity_from_ = *personality.identity.register_;
  for (int i = 0; i < personality.identity.registers; ++i)
    registers_.push_back({{}, {RegisterForm::uint16, identity_from_ + i}});
  const auto address = [](const Spot& spot) { return spot.place.address; };
  std::ranges::sort(registers_, {}, address);
  std::ranges::sort(bits_, {}, address);
}

const RegisterMap::Spot* RegisterMap::find(bool bit, int address) const {
  const auto& spots = bit ? bits_ : registers_;
  const auto behind = std::ranges::upper_bound(spots, address, {},
                                               [](const Spot& spot) { return spot.place.address; });
  if (behind == spots.begin()) return nullptr;
  const Spot& spot = *std::prev(behind);
  return address < spot.place.address + spot.place.size() ? &spot : nullptr;
}

}  // namespace triax::lab
