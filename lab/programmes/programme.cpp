// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/programme.hpp"

namespace triax::lab {

FittedChannels standard_channels() {
  FittedChannels fitted{};
  for (const QuantityInfo& row : raw_channels()) fitted[index(row.quantity)] = row.raw.standard;
  return fitted;
}

}  // namespace triax::lab
