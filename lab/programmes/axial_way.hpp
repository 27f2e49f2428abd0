// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The ways to drive the axis in a stage, as rows of one list: the word in a programme, the keys it
// reads, what its control loop looks at and what it asks for. A new way is an enumerator and a row.
#include <span>
#include <string_view>
#include <vector>

#include "lab/results/quantity.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

class TomlTable;
struct LoadingFrame;
struct Stage;

/// What the axis does in a stage.
enum class AxialAction {
  free,          ///< no piston: q = 0, the cap follows the specimen
  hold,          ///< the crosshead stands
  displacement,  ///< the crosshead moves at a velocity
  spring,        ///< the same through a spring (Servant et al. 2005)
  load,          ///< the cylinder's servo follows a force
  dead_load,     ///< masses on the piston: the force stays, whatever the specimen does
  constant_q,    ///< the servo follows q times the current area
  stress_ratio,  ///< the servo follows η p′: anisotropic consolidation
};

/// What a servo decides by, SI: what it saw when the stage began and sees now.
struct AxisView {
  double force_at_start_n = 0;
  double q_at_start_pa = 0;
  double stage_time_s = 0;  ///< at the end of the tick, as the next
  double cell_pa = 0;       ///< asked for then
  double pore_pa = 0;       ///< read
};

struct AxialWay {
  enum class Drive {
    none,       ///< no piston
    crosshead,  ///< at the stage's velocity, through its spring if there is one
    servo,      ///< the cylinder follows what one of the two functions below gives
    masses,     ///< dead load
  };
  using Law = double (*)(const Stage& stage, const AxisView& view);

  AxialAction action;
  std::string_view word;  ///< in a programme
  Drive drive = Drive::none;
  AxialControl control = AxialControl::load;  ///< what that is called in a record
  /// Reads the keys that only this way has; throws BadInput. Null: none.
  void (*read)(const TomlTable& table, const LoadingFrame& frame, Stage& stage) = nullptr;
  std::vector<Quantity> looks_at = {};  ///< channels of the control loop
  /// Of a servo: the force in N, or the deviator stress in Pa that is held on the current area.
  Law force = nullptr, stress = nullptr;
};

/// All ways, in the order of the enumeration.
std::span<const AxialWay> axial_ways();
const AxialWay& way_of(AxialAction action);
/// Whether the cylinder (or masses), not the crosshead, moves the cap.
bool by_force(AxialAction action);

}  // namespace triax::lab
