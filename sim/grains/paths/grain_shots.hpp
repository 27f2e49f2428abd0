// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds the strain increment of a specimen of grains that meets two linear conditions on the
// increments of stress and strain: shots from one and the same state, until one meets them.
//
//   S Δσ(Δε) + E Δε = f dy,   Δσ(Δε) what the walls show after strain_box
//
// The state between two shots is not kept, so that Δσ is one continuous function of Δε whatever the
// grains do of themselves meanwhile (they creep), and Broyden's method converges in two or three.
#include "sim/control/control_solver.hpp"
#include "sim/grains/paths/box_strain.hpp"
#include "sim/grains/paths/secant_stiffness.hpp"

namespace triax::sim {

struct ShotLimits {
  StrainPace pace;
  double stress_tolerance_pa = 1;  ///< that conditions may be missed by, rows scaled to stresses
  /// |Δε| (or thirty times the elastic strain, if that is more) from which on conditions count
  /// as impossible to meet. A loss that heals within it is part of the increment.
  double runaway_strain = 1e-3;
  /// Where two shots did not come as near (the grains jump now and then), each further one may
  /// miss by √10 times more, up to so many times.
  double most_loosened = 100;
  int most_shots = 10;
};

struct Shot {
  bool met = false;
  bool ran_away = false;  ///< not met within the bound of strain
  GrainState grains;      ///< after the shot that came nearest
  Vector<Axisymmetric> stress = Vector<Axisymmetric>::Zero();  ///< Δσ, Pa
  Vector<Axisymmetric> strain = Vector<Axisymmetric>::Zero();
  Matrix<Axisymmetric> stiffness;  ///< K that the next shot would have used
  double missed_pa = 0;
  int shots = 0;
};

/// σ of the walls as (axial, √2 radial), Pa.
Vector<Axisymmetric> stress_of(const GrainState& grains);

/// One shot by a given strain.
Shot shoot(const GrainState& from, const Vector<Axisymmetric>& strain, const StrainSteps& steps);

/// `fraction` of the control's increment from a state at rest. Throws GrainsFailed.
Shot meet(const GrainState& from, const SecantStiffness& secant,
          const PreparedControl<Axisymmetric>& control, double fraction, const ShotLimits& limits);

}  // namespace triax::sim
