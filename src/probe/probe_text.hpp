// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/probe/probe_result.hpp"

namespace triax::src {

/// What a text tells of each state besides.
struct ProbeDetails {
  bool probes = false;   ///< every direction
  bool control = false;  ///< controllability over R and under named controls
};

/// A table of the states for people, and where a test's own increment lies.
std::string probe_text(const study::ProbeResult& result, const ProbeDetails& details);

}  // namespace triax::src
