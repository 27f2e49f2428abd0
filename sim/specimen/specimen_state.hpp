// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>

#include "sim/point/point_driver.hpp"
#include "sim/specimen/run_away.hpp"

namespace triax::sim {

/// A specimen at an instant. A plain value: copy, compare, save, restore.
struct SpecimenState {
  PointState<Axisymmetric> material;
  double pore_pressure = 0;  ///< u, Pa above the atmosphere
  double cell_pressure = 0;  ///< σ_c, Pa; the membrane may carry part of it
  double height_m = 0;
  /// Water that left through the valve since the start, its volume as at the pore pressure of the
  /// start.
  double drained_volume_m3 = 0;
  double air_pa_m3 = 0;         ///< amount of air, free and dissolved: absolute pressure × volume
  double velocity_m_per_s = 0;  ///< of the cap, compression positive; mean of the last step
  /// F_a at the end of the last step: where a drive with a spring, or one that must not jump, goes
  /// on from. F itself unless the cap is in motion or at its stop.
  double applied_force_n = 0;
  RunAway run_away;
};

/// Work of a step, J; trapezoid over each part that was integrated, so that what is left of
/// balance() falls with the square of the step, relative to the work.
struct StepWork {
  double axial = 0;     ///< by the drive, F_a dx; by a rigid cap F dx
  double cell = 0;      ///< by the cell, −σ_c dV of what the membrane encloses
  double drainage = 0;  ///< by the back pressure, −u_b dV of outflow
  double skeleton = 0;  ///< into it, V σ′:dε
  double membrane = 0;  ///< into it, stretching and penetration
  double water = 0;     ///< into pore water, air and lines, and lost in the drainage resistance
  double damping = 0;   ///< lost in the damper
  double stop = 0;      ///< taken by the stop: kinetic energy there
  double kinetic = 0;   ///< change of kinetic energy
  double impulse = 0;   ///< given by an impulse

  /// What came in less what can be told of it; 0 but for the error of the trapezoid.
  double balance() const {
    return axial + cell + drainage + impulse - skeleton - membrane - water - damping - stop -
           kinetic;
  }
};

struct SpecimenStep {
  StepOutcome outcome = StepOutcome::failed;
  SpecimenState state;  ///< at the end of what could be done
  double done_s = 0;
  AxisymmetricStress stress_increment;  ///< effective, of the part done
  AxisymmetricStrain strain_increment;  ///< natural, of the part done
  StepWork work;
  std::string message;     ///< empty when accepted
  bool law_ended = false;  ///< failed because the law goes no further
  bool at_stop = false;    ///< the cap rests against its stop
  bool ran_away = false;   ///< some of the step was integrated with inertia after loss of control
  int substeps = 0;        ///< parts the step was integrated in
  /// Steps in which the law was integrated, those of parts that were given up among them.
  std::int64_t law_steps = 0;
};

}  // namespace triax::sim
