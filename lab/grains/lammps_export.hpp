// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A specimen of grains and a path for LAMMPS, which runs it on many processors:
//
//   mpirun -n 8 lmp -in PREFIX.lammps.in        in the folder of the files
//
// The script writes a table with a row a point of the path (kLammpsColumns). It was made for and
// run with LAMMPS of 29 Sep 2021 (packages GRANULAR and ASPHERE). The same there and here: the
// grains (places, radii, masses, velocities, spins), the time step, k_t/k_n, the friction, walls
// without friction with the k_n of each grain's own radius (they are forces of atom variables),
// walls that move at each step by natural strain about the same middle, local damping of forces.
// Not the same:
//
//  - k_n goes by kinds of grains, which are bins of size: right on the mean, off by a few per cent
//    from contact to contact (the script's head says how far)
//  - a data file holds no tangential forces: contacts start without. The script therefore first
//    lets the grains settle with the stresses of the start held on each axis, and counts strains
//    from there; a start far from isotropic gives way more than it should
//  - there is no local damping of moments: turning is damped by dashpots along contacts instead,
//    with the damping ratio α/π, which takes of a vibration what local damping does. Fast or
//    collapsing specimens feel the difference: they move more
//  - walls under stress are held by a servo of its own, with a memory on drained paths; it settles
//    at the same stress
//  - the kinetic energy is that of the instant, not the most since the last row; "unbalanced" has
//    the damping in it and is over the mean normal force
//  - marks and pictures of the path are not taken; the path's ends are looked for at its rows only
#include <string>
#include <vector>

#include "sim/grains/paths/grain_path.hpp"

namespace triax::lab {

struct LammpsOptions {
  std::string title;       ///< "PROGRAMME, stage NAME", for the heads of the files; one line
  std::string data_file;   ///< names as the script has them: beside it, without folders
  std::string table_file;  ///< that LAMMPS writes
  int bins = 12;           ///< of size, 1 to 64
};

struct LammpsExport {
  std::string data;    ///< atom_style sphere; ids are those of the description and 1
  std::string script;  ///< of commands
};

inline constexpr const char* kLammpsColumns =
    "time_s,axial_strain,radial_strain,volumetric_strain,axial_stress_kPa,radial_stress_kPa,p_kPa,"
    "q_kPa,path_stress_kPa,kinetic_energy_J,unbalanced,strain_x,strain_y,strain_z,stress_x_kPa,"
    "stress_y_kPa,stress_z_kPa";

/// The state at the start of a path and the path. Throws std::invalid_argument: bins out of range,
/// a name of a file that LAMMPS would take apart (quotes, $, &, line ends), a path whose pressure,
/// rate, strain or ratio is not above 0.
LammpsExport lammps_export(const sim::GrainState& state, const sim::GrainPath& path,
                           const LammpsOptions& options);

}  // namespace triax::lab
