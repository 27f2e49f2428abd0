// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A state of a specimen of grains as pictures for ParaView: text of .vtp files (vtk_document.hpp).
// Compression positive, SI, the unit in the name of each array. Positions are those of the state;
// forces are those of the last step (sim/grains/state/grain_measures.hpp).
#include <string>

#include "lab/grains/vtk_document.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::lab {

/// Grains as points in the order of the description: "Point Gaussian" or spheres as glyphs, scaled
/// by radius_m, show them.
///
///   radius_m, id, velocity_m_per_s, spin_rad_per_s
///   kinetic_energy_J    ½ m v² + ½ I ω²
///   contacts            with grains and walls
///   floating            1 without any contact
///   pressure_Pa         mean stress in the grain, −1/(3 V_grain) Σ f · (arm to the contact);
///   summed
///                       over V_grain it is the specimen's p × V
///
/// `title` goes into the head of the file, after "simulated".
std::string vtk_grains(const sim::GrainState& state, const std::string& title);

/// Contacts as lines between centres, and from a centre to its foot on a wall.
///
///   normal_force_N, tangential_force_N
///   slides              1 at Coulomb's limit
///   wall                −1 between grains, else 0 to 5: low and high of the axes x, y, z
std::string vtk_contacts(const sim::GrainState& state, const std::string& title);

/// The box as its twelve edges; as fields of the whole wall_pressure_Pa (of the six walls) and
/// strain_rate_per_s (of the three axes).
std::string vtk_box(const sim::GrainState& state, const std::string& title);

}  // namespace triax::lab
