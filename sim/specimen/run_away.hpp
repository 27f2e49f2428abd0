// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A run-away and the check of the paper's Eq. (5), which relates the kinetic energy that arises
// from an equilibrium under constant loads to the second-order work of the increment since:
//
//   2 E_c = −W2
//
// W2 is that of the specimen's own increments since the start, natural strains, V and H there:
//
//   W2 = V (Δσ′:Δε − Δσ₃′ Δε_v + Δm Δε₁) + F H Δε₁ (Δε₁ − Δε_v) + k (H Δε₁)²
//
// skeleton; what cell and water give back radially (−Δσ₃′ = Δu at constant cell pressure); the
// membrane's axial stress m; change of area; the spring that drives, if there is one.
//
// Eq. (5) ends at second order. With ΔF = k₀ Δx + ½ k₀′ Δx², where k₀ is the specimen's stiffness
// at the start in the direction of the motion, the energy is −½ k₀ Δx² − k₀′ Δx³/6, and so
//
//   E_c/(−W2/2) = 2/3 + (1/3) k₀ Δx/ΔF   (to third order)
//
// Past the peak (equilibrium held by displacement, then handed over to dead load) k₀ < 0 and the
// ratio tends to 1 as the increment shrinks. At a limit point (loads raised until they are no
// longer carried) k₀ = 0: W2 vanishes at the start to second order, third order leads and the ratio
// tends to 2/3. expected_ratio() tells which of the two it is.
namespace triax::sim {

/// The run-away under way or the last one. A plain value inside SpecimenState.
struct RunAway {
  enum class End { none, arrested, end_of_travel };

  bool under_way = false;
  int count = 0;         ///< run-aways since the specimen was built
  double elapsed_s = 0;  ///< since equilibrium was lost
  End end = End::none;   ///< none: under way, or there was no run-away
  double largest_kinetic_energy_j = 0;
  double largest_at_s = 0;

  // Eq. (5) at the first instant at which the second order stands out of the first by kResolved.
  static constexpr double kResolved = 100;
  double compared_at_s = 0;  ///< 0: not yet
  double kinetic_energy_j = 0;
  double second_order_work_j = 0;         ///< W2
  double spring_stiffness_n_per_m = 0;    ///< k of the drive
  double stiffness_at_start_n_per_m = 0;  ///< k₀ + k; NaN: unknown, or of time as well (flow)
  double secant_stiffness_n_per_m = 0;    ///< ΔF/Δx + k
  double initial_kinetic_energy_j = 0;    ///< of an impulse, or of the quasi-static velocity
  /// ∫(F_a − F₀) dx without the spring: first-order work of a load step or of loads that go on
  /// changing.
  double first_order_work_j = 0;
  double damping_work_j = 0;  ///< ∫c v dx

  /// Kinetic energy that came from the specimen (above that of the perturbation and with what the
  /// damper took) over −W2/2. Pre-condition: compared_at_s > 0.
  double ratio() const {
    return (kinetic_energy_j - initial_kinetic_energy_j - first_order_work_j + damping_work_j) /
           (-second_order_work_j / 2);
  }
  /// What ratio() is to third order: 1 past a peak, 2/3 from a limit point.
  double expected_ratio() const {
    return (2 + stiffness_at_start_n_per_m / secant_stiffness_n_per_m) / 3;
  }

  bool turned = false;  ///< the cap's velocity has changed its sign since the start

  // The start, for increments since.
  double start_axial_pa = 0, start_radial_pa = 0;  ///< σ′
  double start_height_m = 0, start_volume_m3 = 0;
  double start_force_n = 0, start_membrane_pa = 0;  ///< F, m
};

}  // namespace triax::sim
