// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/lammps_export.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <sstream>
#include <stdexcept>

#include "lab/grains/size_bins.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax;
using Catch::Contains;

namespace {

const sim::GrainState& state() {
  static const sim::GrainState made = [] {
    sim::GrainState begun = sim::test::lattice(4);
    sim::test::shake(begun, 0.01);
    sim::Grains grains(begun);
    grains.drive(sim::triaxial_drives(sim::stress_drive(2e4), sim::stress_drive(1e4)));
    grains.step(500);
    return grains.state();
  }();
  return made;
}

lab::LammpsOptions options() { return {"dense.toml, stage R", "a.lammps.data", "a.csv", 5}; }

lab::LammpsExport exported(const sim::GrainPath& path) {
  return lab::lammps_export(state(), path, options());
}

sim::GrainPath strain_path(double ratio) {
  sim::GrainPath path;
  path.kind = sim::GrainPathKind::strain_path;
  path.ratio = ratio;
  path.strain_rate_per_s = 0.5;
  path.axial_strain = 0.01;
  path.samples = 100;
  return path;
}

/// The lines after the one that begins with `title` and the blank one below it.
std::vector<std::vector<double>> section(const std::string& data, const std::string& title) {
  std::istringstream lines(data.substr(data.find('\n' + title) + 1));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line) && !line.empty()) {
    std::istringstream numbers(line);
    rows.emplace_back();
    for (double x = 0; numbers >> x;) rows.back().push_back(x);
  }
  return rows;
}

}  // namespace

TEST_CASE("the data file for LAMMPS has each grain as the state has it, to the digit") {
  const std::string data = exported(strain_path(1)).data;
  CHECK_THAT(data.substr(0, data.find('\n')), Contains("simulated") && Contains("dense.toml"));
  CHECK_THAT(data, Contains("\n64 atoms\n5 atom types\n"));
  const auto atoms = section(data, "Atoms # sphere"), velocities = section(data, "Velocities");
  REQUIRE(atoms.size() == 64);
  REQUIRE(velocities.size() == 64);
  const lab::SizeBins bins = lab::size_bins(state(), 5);
  for (std::size_t i = 0; i < 64; ++i) {
    const sim::Grain& g = state().grains[i];
    const std::vector<double> atom{state().ids[i] + 1.0, bins.of[i] + 1.0, 2 * g.radius, 3000.0,
                                   g.position[0],        g.position[1],    g.position[2]};
    const std::vector<double> velocity{state().ids[i] + 1.0,
                                       g.velocity[0],
                                       g.velocity[1],
                                       g.velocity[2],
                                       g.spin[0],
                                       g.spin[1],
                                       g.spin[2]};
    CHECK(atoms[i] == atom);
    CHECK(velocities[i] == velocity);
  }
}

TEST_CASE("the script for LAMMPS says that it is simulated, and what differs") {
  const std::string script = exported(strain_path(1)).script;
  CHECK(script.rfind("# simulated: dense.toml, stage R\n", 0) == 0);
  for (const char* limit : {"5 bins of size", "root mean square", "without tangential forces",
                            "local damping of forces only", "servo of its own", "kinetic energy"})
    CHECK_THAT(script, Contains(limit));
  CHECK_THAT(script, Contains("read_data a.lammps.data\n") && Contains("timestep 1e-06\n"));
  CHECK_THAT(script, Contains(fmt::format("print \"{}\" file a.csv", lab::kLammpsColumns)));
}

TEST_CASE("pairs of bins have the law's stiffness, friction and ratio of stiffnesses") {
  const std::string script = exported(strain_path(1)).script;
  const lab::SizeBins bins = lab::size_bins(state(), 5);
  int lines = 0;
  std::istringstream all(script);
  for (std::string line; std::getline(all, line);) {
    if (line.rfind("pair_coeff ", 0) != 0) continue;
    std::istringstream words(line);
    std::string skipped;
    std::size_t i = 0, j = 0;
    double kn = 0, damping = 0, kt = 0, tangential_damping = 0, friction = 0;
    words >> skipped >> i >> j >> skipped >> kn >> damping >> skipped >> skipped >> kt >>
        tangential_damping >> friction;
    CHECK(kn ==
          Approx(sim::normal_stiffness(state().law, bins.radius_m[i - 1], bins.radius_m[j - 1])));
    CHECK(kt == Approx(0.42 * kn));
    CHECK(friction == Approx(sim::friction_coefficient(state().law)));
    CHECK(damping * tangential_damping > 1e3);
    ++lines;
  }
  CHECK(lines == 15);
}

TEST_CASE("each kind of path drives the axes that it drives here") {
  const std::string undrained = exported(strain_path(1)).script,
                    path = exported(strain_path(0.8)).script;
  CHECK_THAT(undrained, Contains("variable ez equal \"v_ez0+0.5*(step-v_s0)*dt\"") &&
                            Contains("variable ex equal \"v_ex0+-0.25*(step-v_s0)*dt\""));
  CHECK_THAT(path, Contains("variable ey equal \"v_ey0+-0.3125*(step-v_s0)*dt\"") &&
                       Contains("v_s1-v_s3/0.8"));
  // From row to row 0.01/0.5/100 s.
  CHECK_THAT(path, Contains("\nrun 200 pre no post no\njump SELF row\n"));

  sim::GrainPath drained = strain_path(1);
  drained.kind = sim::GrainPathKind::drained;
  drained.pressure_pa = 12345;
  drained.stress_ratio = 0.77;
  const std::string held = exported(drained).script;
  const std::string after = held.substr(held.find("# The path"));
  CHECK_THAT(after, Contains("variable goalx equal 12345\n") &&
                        Contains("variable goaly equal 12345\n") &&
                        Contains("variable ez equal \"v_ez0+0.5*(step-v_s0)*dt\"") &&
                        Contains("variable dz equal 0.0") && Contains("'end: stress ratio'") &&
                        Contains("0.77*v_p"));

  sim::GrainPath isotropic;
  isotropic.kind = sim::GrainPathKind::isotropic;
  isotropic.pressure_pa = 54321;
  CHECK_THAT(exported(isotropic).script,
             Contains("variable goalz equal 54321\n") && Contains("'end: at rest'"));
  isotropic.stress_rate_pa_per_s = 1e6;
  CHECK_THAT(exported(isotropic).script,
             Contains("variable risenz equal \"1000000*(step-v_s0)*dt"));
}

TEST_CASE("the script rests with the stresses of the start") {
  const std::string script = exported(strain_path(1)).script;
  const std::string rest =
      script.substr(script.find("# Rest"), script.find("# The path") - script.find("# Rest"));
  std::istringstream found(rest.substr(rest.find("goalz equal ") + 12));
  double goal = 0;
  found >> goal;
  CHECK(goal == Approx(sim::wall_stress(state().walls, state().box, 2)));
  CHECK_THAT(rest, Contains("unfix servo"));
}

TEST_CASE("what LAMMPS would take apart, or cannot do, is refused") {
  const auto refused = [](const auto& change, const char* words) {
    lab::LammpsOptions changed = options();
    sim::GrainPath path = strain_path(1);
    change(changed, path);
    CHECK_THROWS_WITH(lab::lammps_export(state(), path, changed), Contains(words));
  };
  for (const char* name : {"", "a b", "a&", "$x", "a\"b", "a\nb", "x/y", "#"}) {
    refused([&](auto& o, auto&) { o.data_file = name; }, "names of its files");
    refused([&](auto& o, auto&) { o.table_file = name; }, "names of its files");
  }
  refused([](auto& o, auto&) { o.bins = 0; }, "1 to 64 bins");
  refused([](auto& o, auto&) { o.bins = 65; }, "1 to 64 bins");
  refused([](auto&, auto& p) { p.strain_rate_per_s = 0; }, "above 0");
  refused([](auto&, auto& p) { p.ratio = -1; }, "above 0");
  refused([](auto&, auto& p) { p.axial_strain = 0; }, "above 0");

  lab::LammpsOptions titled = options();
  titled.title = "two\nlines & ${more} &";
  const std::string script = lab::lammps_export(state(), strain_path(1), titled).script;
  CHECK(script.rfind("# simulated: two lines    {more}  \n", 0) == 0);
}
