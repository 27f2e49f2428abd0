// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A value in the unit of the field as the bits of its registers, for both sides of the line.
#include <string>
#include <string_view>

#include "lab/wire/personality.hpp"

namespace triax::lab {

/// Two bytes a register, high byte first. NaN becomes what stands for "no value"; a scaled integer
/// stays at the end of its range. Pre-condition: no bit.
std::string registers_of(const PointRegister& place, double value);
/// NaN where the registers say that there is no value. Pre-condition: size() registers.
double value_of(const PointRegister& place, std::string_view bytes);
/// Whether the registers can hold the value to within half a step.
bool can_hold(const PointRegister& place, double value);

}  // namespace triax::lab
