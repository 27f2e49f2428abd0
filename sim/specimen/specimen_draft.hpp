#pragma once
// DRAFT of the interface of sim/specimen/ (replaces specimen.hpp; split into files as it grows).
//
// Axis. x = H_0 − H is the cap's displacement, F = (q + q_m) A the specimen's force above the cell
// pressure (q_m: membrane). What pushes the cap:
//   free    no piston: F = 0
//   rigid   the cap moves at a velocity
//   force   F_a(s) = force_n + force_rate s − stiffness (x(s) − x(0)),   0 ≤ s ≤ dt
//           load cylinder or dead load: stiffness 0; spring, or frame and load cell of finite
//           stiffness k driven at velocity v: force_n = F now, force_rate = k v, stiffness = k
// Quasi-static: F = F_a at the end of the step. Where that cannot be met (the point driver loses
// control) and the moving mass is not 0, the rest of the step, and all later ones until it is over,
// are integrated with inertia: m a = F_a − F − c v (velocity Verlet, steps from the stiffness in
// hand, error-controlled). It is over when the cap is at rest in a new equilibrium; the end of
// travel stops it too. `inertial` asks for inertia from the start of the step (perturbations).
//
// Water. V dε_v = C du − C_m dσ₃′ + Q dt; closed: Q = 0; drained: Q = (u − u_b)/R; flow: Q given
// (volume-controlled: proportional strain paths). C: water, lines, air by Boyle and Henry; C_m:
// membrane penetration. What a finite step leaves of the balance is made good by the next, so that
// nothing accumulates.
struct AxialDrive {
  enum class Kind { free, rigid, force };
  Kind kind = Kind::free;
  double velocity_m_per_s = 0;
  double force_n = 0, force_rate_n_per_s = 0, stiffness_n_per_m = 0;
  double mass_kg = 0, damping_n_s_per_m = 0;
  double impulse_n_s = 0;  ///< given to the mass at the start of the step (m v jumps); needs mass
  bool inertial = false;
  double travel_m = 0;     ///< x at which a stop catches the cap; 0: none
};
struct WaterDrive {
  enum class Kind { closed, drained, flow };
  Kind kind = Kind::closed;
  double back_pressure_pa = 0, back_pressure_rate_pa_per_s = 0;
  double flow_m3_per_s = 0;  ///< out of the specimen
};
struct SpecimenBoundary {
  AxialDrive axis;
  double cell_pressure_rate_pa_per_s = 0;
  WaterDrive water;
};
/// The run-away under way or the last one; a plain value inside SpecimenState.
struct RunAway {
  enum class End { none, arrested, end_of_travel };
  double elapsed_s = 0;           ///< since equilibrium was lost
  double largest_kinetic_energy_j = 0, largest_at_s = 0;
  // Eq. (5), over the first increment after the start that is resolved:
  double compared_at_s = 0;       ///< 0: not yet
  double kinetic_energy_j = 0;    ///< from the velocity
  double second_order_work_j = 0; ///< W2 from the specimen's own stress and strain increments
  End end = End::none;
};
