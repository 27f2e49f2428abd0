// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/paths/path_description.hpp"
#include "sim/point/path_runner.hpp"

namespace triax::lab {

/// A path file that tries the failed increment again, from the state before it with the law's
/// memory: read back, it comes to the same outcome. Numbers have all their digits. `message` goes
/// into a remark at its head.
template <class Space>
std::string failed_increment_toml(const PathDescription& description,
                                  const sim::FailedIncrement<Space>& failed,
                                  const std::string& message);

}  // namespace triax::lab
