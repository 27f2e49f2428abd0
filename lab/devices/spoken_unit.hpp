// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/results/quantity.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// The unit in which programmes and messages speak of a raw channel: that of its column, save that
/// a load cell is spoken of in newtons, although its column is in kN.
sim::Unit spoken_unit(Quantity channel);

}  // namespace triax::lab
