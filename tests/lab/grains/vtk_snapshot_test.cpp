// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/vtk_snapshot.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <numeric>

#include "sim/grains/state/grain_measures.hpp"
#include "tests/lab/grains/vtk_reading.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax;
using lab::test::read_vtk;

namespace {

/// Compressed and sheared; some of its grains float, some contacts slide.
sim::GrainState specimen() {
  sim::GrainState state = sim::test::lattice(5);
  sim::test::shake(state, 0.05);
  sim::Grains grains(state);
  grains.drive({sim::stress_drive(2e4), sim::strain_rate_drive(0.5), sim::stress_drive(1e4)});
  grains.step(3000);
  return grains.state();
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("a picture of the grains shows each as the state has it") {
  const sim::GrainState state = specimen();
  const sim::GrainMeasures measures = sim::measure(state);
  const auto read = read_vtk(lab::vtk_grains(state, "sand <1>"));
  REQUIRE(read.well_formed);
  CHECK(read.comment.find("simulated") != std::string::npos);
  CHECK(read.comment.find("sand <1>") != std::string::npos);
  CHECK(read.piece.at("NumberOfPoints") == "125");
  CHECK(read.piece.at("NumberOfVerts") == "125");
  CHECK(read.arrays.at("TimeValue").at(0) == state.time_s);
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const sim::Grain& g = state.grains[i];
    const std::int32_t id = state.ids[i];
    CHECK(read.arrays.at("id")[id] == id);
    CHECK(read.arrays.at("radius_m")[id] == Approx(g.radius));
    for (int a = 0; a < 3; ++a) {
      CHECK(read.arrays.at("position_m")[3 * id + a] == g.position[a]);
      CHECK(read.arrays.at("velocity_m_per_s")[3 * id + a] == Approx(g.velocity[a]));
      CHECK(read.arrays.at("spin_rad_per_s")[3 * id + a] == Approx(g.spin[a]));
    }
  }
  for (const char* name : {"radius_m", "id", "kinetic_energy_J", "contacts", "floating",
                           "pressure_Pa", "velocity_m_per_s", "spin_rad_per_s"}) {
    INFO(name);
    CHECK(read.parents.at(name) == "PointData");
    const auto components = std::stoul(read.array_attributes.at(name).at("NumberOfComponents"));
    CHECK(read.arrays.at(name).size() == 125 * components);
  }
  CHECK(sum(read.arrays.at("kinetic_energy_J")) == Approx(measures.kinetic_energy_j));
  CHECK(sum(read.arrays.at("contacts")) == Approx(measures.coordination * 125));
  CHECK(sum(read.arrays.at("floating")) == static_cast<double>(measures.floating_grains));
}

TEST_CASE("pressures in the grains are those of the specimen, by volume") {
  const sim::GrainState state = specimen();
  const auto read = read_vtk(lab::vtk_grains(state, "sand"));
  double sum_of = 0;
  for (std::size_t k = 0; k < state.grains.size(); ++k) {
    const double r = read.arrays.at("radius_m")[k];
    sum_of += read.arrays.at("pressure_Pa")[k] * 4 * std::numbers::pi / 3 * r * r * r;
  }
  const double p = sim::measure(state).stress_pa.trace() / 3;
  REQUIRE(p > 1e3);
  CHECK(sum_of == Approx(p * state.box.volume_m3()).epsilon(1e-5));
}

TEST_CASE("a picture of the contacts shows every force once") {
  const sim::GrainState state = specimen();
  const auto contacts = sim::contacts_of(state);
  const sim::GrainMeasures measures = sim::measure(state);
  REQUIRE(measures.sliding_contacts > 0);
  const auto read = read_vtk(lab::vtk_contacts(state, "sand"));
  REQUIRE(read.well_formed);
  CHECK(read.piece.at("NumberOfLines") == std::to_string(contacts.size()));
  CHECK(read.piece.at("NumberOfPoints") == std::to_string(125 + measures.wall_contacts));
  CHECK(sum(read.arrays.at("slides")) == static_cast<double>(measures.sliding_contacts));
  const auto& points = read.arrays.at("position_m");
  const auto& ends = read.arrays.at("connectivity");
  std::int64_t at_walls = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const sim::GrainContact& c = contacts[k];
    CHECK(read.arrays.at("normal_force_N")[k] == Approx(c.normal_force_n));
    CHECK(read.arrays.at("tangential_force_N")[k] == Approx(c.tangential_force_n));
    CHECK(read.arrays.at("offsets")[k] == 2 * (static_cast<double>(k) + 1));
    const auto from = static_cast<int>(ends[2 * k]), to = static_cast<int>(ends[2 * k + 1]);
    const double wall = read.arrays.at("wall")[k];
    Eigen::Vector3d line;
    for (int a = 0; a < 3; ++a) line[a] = points[3 * to + a] - points[3 * from + a];
    // The line is the branch, but for the one step between forces and positions.
    CHECK((line - c.branch_m).norm() < 1e-5);
    CHECK(wall == (c.j < 0 ? -1 - c.j : -1));
    at_walls += wall >= 0;
  }
  CHECK(at_walls == measures.wall_contacts);
}

TEST_CASE("a picture of the box has its twelve edges and what pushes its walls") {
  const sim::GrainState state = specimen();
  const auto read = read_vtk(lab::vtk_box(state, "sand"));
  REQUIRE(read.well_formed);
  CHECK(read.piece.at("NumberOfPoints") == "8");
  CHECK(read.piece.at("NumberOfLines") == "12");
  const auto& points = read.arrays.at("position_m");
  double length = 0;
  for (int k = 0; k < 12; ++k) {
    const auto from = static_cast<int>(read.arrays.at("connectivity")[2 * k]),
               to = static_cast<int>(read.arrays.at("connectivity")[2 * k + 1]);
    for (int a = 0; a < 3; ++a) length += points[3 * to + a] - points[3 * from + a];
  }
  CHECK(length ==
        Approx(4 * (state.box.length_m(0) + state.box.length_m(1) + state.box.length_m(2))));
  for (int w = 0; w < 6; ++w)
    CHECK(read.arrays.at("wall_pressure_Pa")[w] ==
          state.walls.force_n[w] / state.box.area_m2(w / 2));
  CHECK(read.arrays.at("strain_rate_per_s")[1] == 0.5);
  CHECK(read.parents.at("wall_pressure_Pa") == "FieldData");
}

TEST_CASE("grains without a contact make pictures too") {
  const auto state = sim::test::pair_of(1e-3, 2e-3, -1e-3, sim::test::undamped());
  CHECK(read_vtk(lab::vtk_grains(state, "")).arrays.at("floating") == std::vector<double>{1, 1});
  const auto contacts = read_vtk(lab::vtk_contacts(state, ""));
  CHECK(contacts.well_formed);
  CHECK(contacts.piece.at("NumberOfLines") == "0");
}
