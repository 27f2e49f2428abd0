// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who answers, what each channel says, and what is wrong, before a test relies on it.
#include <functional>
#include <string>
#include <vector>

#include "lab/wire/rig_file.hpp"

namespace triax::lab {

struct ChannelCheck {
  std::string name, unit;
  double value = 0;     ///< the first, calibrated, in the unit; NaN: none came
  double noise = 0;     ///< standard deviation of kRigLooks looks, in the unit; NaN: too few
  std::string trouble;  ///< empty: none
};

struct InstrumentCheck {
  std::string name, link, identity;
  double answer_s = 0;  ///< median time from question to answer; NaN: none came
  std::string trouble;  ///< empty: none
  std::vector<ChannelCheck> channels;
};

/// Channels are looked at so often, half a second apart.
inline constexpr int kRigLooks = 8;

/// Asks every instrument of the rig who it is, reads all channels again and again, and asks drives
/// for their state. Sets nothing. Throws BadInput where the file asks for what an instrument has
/// not.
std::vector<InstrumentCheck> check_rig(const RigFile& rig, double within_s,
                                       const std::function<bool()>& stop = {});
/// Whether anything is wrong.
bool all_well(const std::vector<InstrumentCheck>& checks);

}  // namespace triax::lab
