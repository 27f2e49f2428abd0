// SPDX-License-Identifier: GPL-3.0-or-later
// lammps_path KIND PACKING PREFIX [R [STRAIN [RATE [BINS]]]]
//   KIND: strain_path (of R; 1 is undrained), drained, or isotropic to twice the pressure. Settles
//   a packing at 100 kPa, writes the path from there for LAMMPS as PREFIX.lammps.data and
//   PREFIX.lammps.in (whose table is PREFIX.lammps.csv) and follows it here: PREFIX.triax.csv from
//   the state as it is, PREFIX.bare.csv from one that lost its tangential forces and came to rest
//   again, as LAMMPS has to.
// PACKING: "N lox hix loy hiy loz hiz", then "x y z r" for each grain, in metres.
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "lab/grains/lammps_export.hpp"
#include "sim/grains/engine/calming.hpp"
#include "sim/grains/paths/grain_path.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

using namespace triax;

namespace {

constexpr double kStress_Pa = 1e5;

sim::GrainState read_packing(const std::string& path) {
  std::ifstream in(path);
  std::size_t count = 0;
  sim::GrainBox box;
  in >> count;
  for (int a = 0; a < 3; ++a) in >> box.low_m[a] >> box.high_m[a];
  std::vector<sim::Sphere> spheres(in ? count : 0);
  for (sim::Sphere& s : spheres)
    in >> s.centre_m[0] >> s.centre_m[1] >> s.centre_m[2] >> s.radius_m;
  if (!in || spheres.empty()) throw std::invalid_argument(path + ": not a packing");
  return sim::make_grain_state(spheres, box, sim::ContactLaw{}, 1.5e-6);
}

sim::GrainState at_rest(const sim::GrainState& state) {
  sim::Grains grains(state, 2);
  grains.drive(sim::triaxial_drives(sim::stress_drive(kStress_Pa), sim::stress_drive(kStress_Pa)));
  const sim::Settled how = sim::settle(grains, {});
  sim::calm(grains);
  fmt::print("# at rest in {} steps: unbalanced {:.2g}, off by {:.3g} Pa\n", how.steps,
             how.unbalanced, how.stress_error_pa);
  return grains.state();
}

sim::GrainPath path_of(const std::string& kind, double ratio, double strain, double rate) {
  sim::GrainPath path;
  path.ratio = ratio;
  path.axial_strain = strain;
  path.strain_rate_per_s = rate;
  path.samples = 100;
  if (kind == "strain_path") {
    path.kind = sim::GrainPathKind::strain_path;
  } else if (kind == "isotropic") {
    path.kind = sim::GrainPathKind::isotropic;
    path.pressure_pa = 2 * kStress_Pa;
    path.stress_rate_pa_per_s = 1e7;
  } else if (kind != "drained") {
    throw std::invalid_argument(kind + " is no kind of path; strain_path, drained, isotropic are");
  }
  return path;
}

void write(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  if (!(out << text)) throw std::runtime_error(path + ": cannot be written");
}

void follow(const sim::GrainState& state, const sim::GrainPath& path, const std::string& file) {
  const sim::GrainPathResult result = sim::follow(state, path, 2);
  std::string table =
      "time_s,axial_strain,radial_strain,volumetric_strain,axial_stress_kPa,radial_stress_kPa,"
      "p_kPa,q_kPa,path_stress_kPa,kinetic_energy_J,unbalanced\n";
  for (const sim::GrainPathPoint& p : result.points)
    table +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", p.time_s, p.strain.axial, p.strain.radial,
                    p.volumetric_strain, p.stress.axial / 1e3, p.stress.radial / 1e3, p.p_pa / 1e3,
                    p.q_pa / 1e3, p.path_stress_pa / 1e3, p.kinetic_energy_j, p.unbalanced);
  write(file, table);
}

int run(int count, char** words) {
  const auto number = [&](int place, double otherwise) {
    return count > place ? std::atof(words[place]) : otherwise;
  };
  const std::string prefix = words[3];
  const sim::GrainPath path = path_of(words[1], number(4, 1), number(5, 0.02), number(6, 0.2));
  const sim::GrainState state = at_rest(read_packing(words[2]));
  const std::string name = std::filesystem::path(prefix).filename().string();
  const lab::LammpsExport files = lab::lammps_export(
      state, path,
      {name, name + ".lammps.data", name + ".lammps.csv", static_cast<int>(number(7, 12))});
  write(prefix + ".lammps.data", files.data);
  write(prefix + ".lammps.in", files.script);
  follow(state, path, prefix + ".triax.csv");
  follow(at_rest(sim::make_grain_state(sim::spheres_of(state), state.box, state.law,
                                       state.time_step_s)),
         path, prefix + ".bare.csv");
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count < 4) {
    fmt::print(stderr, "lammps_path KIND PACKING PREFIX [R [STRAIN [RATE [BINS]]]]\n");
    return 2;
  }
  try {
    return run(count, words);
  } catch (const std::exception& error) {
    fmt::print(stderr, "lammps_path: {}\n", error.what());
    return 1;
  }
}
