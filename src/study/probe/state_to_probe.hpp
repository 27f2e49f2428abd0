// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A state that is to be probed, and where it comes from.
#include <optional>
#include <string>
#include <vector>

#include "sim/law/law.hpp"
#include "src/study/probe/tested_state.hpp"

namespace triax::study {

/// A row of a path as the path made it.
template <class Space>
struct PassedRow {
  sim::PointState<Space> state;
  sim::Vector<Space> strain;  ///< since the start of the path
};

template <class Space>
struct StateToProbe {
  sim::PointState<Space> state;
  std::string name;                    ///< empty: p′, q and e say it
  bool from_path = false;              ///< its memory is what a path made of it
  std::optional<double> axial_strain;  ///< since the start of that path
  std::optional<TestedState> test;     ///< that the state was measured in
  /// Along a path: its rows from the state probed before to this one, both included.
  std::vector<PassedRow<Space>> passed = {};
};

}  // namespace triax::study
