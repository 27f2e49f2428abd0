// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "lab/wire/asked_value.hpp"
#include "lab/wire/remote/reply_check.hpp"
#include "lab/wire/rig_file.hpp"

namespace triax::lab {

/// Name and limits of each asked value, the first of which are the instrument's channels. Possible
/// is what the personality says that the instrument can give and what an apparatus can have
/// (RawChannel::absurd), both in the unit of the instrument.
std::vector<ReplyPlace> reply_places(const RigInstrument& instrument,
                                     const std::vector<AskedValue>& asked);

}  // namespace triax::lab
