// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What can happen on the way of a path.
#include <string>

#include "sim/point/path_point.hpp"

namespace triax::sim {

enum class PathEventKind {
  end_condition,      ///< `what`: the condition's label
  second_order_work,  ///< turns negative: W₂ = 0 here
  peak,               ///< of |q| or of the stress part of a condition: `what`
  control_limit,      ///< the determinant of the control vanishes; `what`: the condition's label
};

template <class Space>
struct PathEvent {
  PathEventKind kind = PathEventKind::end_condition;
  std::string what;
  PathPoint<Space> at;
};

}  // namespace triax::sim
