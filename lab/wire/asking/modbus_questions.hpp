// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/wire/asking/questions.hpp"
#include "lab/wire/modbus/frames.hpp"

namespace triax::lab {

/// Values whose registers follow each other are asked for, and set, by one frame. The personality
/// lives longer. Pre-condition: it speaks Modbus.
std::unique_ptr<Questions> modbus_questions(const Personality& personality, ModbusFraming framing,
                                            int unit);

}  // namespace triax::lab
