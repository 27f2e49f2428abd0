// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triax::sim {

/// What pushes the cap. x = H_built − H is its displacement, F the specimen's force above the cell
/// pressure, compression positive; s the time since the start of the step.
///
///   free    no piston: F = 0
///   rigid   the cap moves at a velocity
///   force   F_a(s) = force_n + force_rate s − k (x(s) − x(0)) + (stress + stress_rate s) A(s)
///
/// A load cylinder or a dead load has k = 0. A spring, or a frame and load cell of finite stiffness
/// k driven at velocity v, is force_n = F_a as the last step left it (SpecimenState), force_rate =
/// k v. `stress` is for a drive that follows the current area: stress_pa = q alone holds q.
///
/// Quasi-static: F = F_a at the end of the step. Where this cannot be met and the moving mass is
/// not 0, the rest of the step and the next ones are integrated with inertia (InertialMotion),
/// until the cap is at rest in a new equilibrium or at its stop.
struct AxialDrive {
  enum class Kind { free, rigid, force };
  Kind kind = Kind::free;
  double velocity_m_per_s = 0;  ///< rigid
  double force_n = 0;           ///< force, from here on
  double force_rate_n_per_s = 0;
  double stiffness_n_per_m = 0;  ///< k ≥ 0
  double stress_pa = 0;
  double stress_rate_pa_per_s = 0;
  double mass_kg = 0;  ///< of all that moves; 0: no inertia, a force that is not carried is lost
  double damping_n_s_per_m = 0;  ///< c
  double impulse_n_s = 0;        ///< given to the mass at the start of the step; needs a mass
  bool inertial = false;         ///< inertia from the start of the step (a load step); needs a mass
  double travel_m = 0;           ///< |x| at which a stop catches the cap, either way; 0: none
};

/// The water's way out of the specimen.
///
///   closed    Q = 0
///   drained   Q = (u − u_b)/R; R = 0: u = u_b
///   flow      Q given: volume-controlled (proportional strain paths)
struct WaterDrive {
  enum class Kind { closed, drained, flow };
  Kind kind = Kind::closed;
  double back_pressure_pa = 0;  ///< u_b at the start of the step
  double back_pressure_rate_pa_per_s = 0;
  double flow_m3_per_s = 0;  ///< Q, out of the specimen
};

/// What the apparatus does during a step; rates are constant over it.
struct SpecimenBoundary {
  AxialDrive axis;
  double cell_pressure_rate_pa_per_s = 0;
  WaterDrive water;
};

}  // namespace triax::sim
