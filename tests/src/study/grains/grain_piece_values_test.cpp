// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_piece_values.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string>

using namespace triax;
using namespace triax::study;

namespace {

struct Keys {
  std::set<std::string> names;
  int visited = 0;
  template <class T>
  void operator()(const char* key, T&) {
    names.insert(key);
    ++visited;
  }
};

/// Makes every number another one than it was.
struct Shift {
  void operator()(const char*, double& x) { x += 1; }
  void operator()(const char*, std::int64_t& x) { x += 1; }
  void operator()(const char*, bool& x) { x = !x; }
  void operator()(const char*, std::array<double, 3>& x) { x[1] += 1; }
};

}  // namespace

TEST_CASE("the keys of a piece of a rose are different ones for different values") {
  ProbedGrains specimen;
  sim::GrainProbe probe;
  Keys of_specimen, of_probing, of_probe;
  visit_specimen(of_specimen, specimen);
  visit_probing(of_probing, specimen);
  visit_probe(of_probe, probe);
  for (const Keys* keys : {&of_specimen, &of_probing, &of_probe}) {
    CHECK(keys->visited > 5);
    CHECK(static_cast<int>(keys->names.size()) == keys->visited);
  }
}

TEST_CASE("every value of a probe is visited") {
  sim::GrainProbe probe;
  Shift shift;
  visit_probe(shift, probe);
  CHECK(probe.angle + probe.norm_pa + probe.stress.axial + probe.stress.radial == 4);
  CHECK(probe.at_rest);
  CHECK(probe.strain.axial + probe.strain.radial == 2);
  CHECK(probe.work.eulerian() == 3);
  CHECK(probe.work.microscopic() == 3);
  CHECK(probe.work.lagrangian + probe.work.normalised + probe.work.boundary_part == 3);
  CHECK(probe.work.fixed_frame == 1);
  CHECK(probe.work.kinetic_before_j + probe.work.kinetic_after_j == 2);
  CHECK(probe.work.contacts_before + probe.work.opened + probe.work.closed +
            probe.work.slides_after ==
        4);
  CHECK(probe.work.stress_change_pa[1] + probe.work.strain[1] == 2);
  CHECK(probe.most_kinetic_j + probe.sliding_share + probe.unbalanced + probe.stress_error_pa == 4);
  CHECK(probe.steps == 1);
  CHECK(probe.norm_strain == 1);
  CHECK(probe.work.contacts_turning + probe.work.grains_turning + probe.work.out_of_balance == 3);
  const sim::GrainLedger& l = probe.ledger;
  CHECK(l.walls_j + l.friction_j + l.damping_j + l.stopped_j == 4);
  CHECK(l.elastic_start_j + l.elastic_end_j + l.kinetic_start_j + l.kinetic_end_j == 4);
  CHECK(l.walls_impulse[1] + l.damping_impulse[1] + l.stopped_impulse[1] == 3);
  CHECK(l.momentum_start[1] + l.momentum_end[1] == 2);
}
