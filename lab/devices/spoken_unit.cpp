// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/spoken_unit.hpp"

namespace triax::lab {

sim::Unit spoken_unit(Quantity channel) {
  const QuantityInfo& row = info(channel);
  return *sim::find_unit(row.raw.spoken_unit.empty() ? row.unit : row.raw.spoken_unit);
}

}  // namespace triax::lab
