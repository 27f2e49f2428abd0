// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the interval of an onset holds what the virtual specimen itself knows, where a loop, a
// closed valve or coarse converters stand between the two.
#include <catch2/catch.hpp>
#include <string>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax::lab;

namespace {

struct Judged {
  StressInterval at;
  double q = 0, p_eff = 0;
  double eta() const { return q / p_eff; }
};

Judged judge(const Programme& programme, std::uint64_t seed) {
  VirtualRig rig(programme, seed);
  const TestSummary summary = run_session(rig, {});
  REQUIRE(summary.truth);
  REQUIRE(summary.truth->lost_sustainability);
  REQUIRE(summary.collapse.onset);
  REQUIRE(summary.collapse.onset->interval);
  return {*summary.collapse.onset->interval, *summary.truth->q_pa, *summary.truth->p_eff_pa};
}

Programme without_errors_of_scale(const std::string& name) {
  Programme programme = load_programme("samples/programmes/" + name + ".toml");
  for (Transducer& t : programme.transducers)
    t.offset = t.drift_per_hour = t.hysteresis = t.nonlinearity = 0;
  return programme;
}

/// 12 bits over 2 MPa, 5 kN and 50 mm.
Programme cheap(const std::string& name) {
  Programme programme = without_errors_of_scale(name);
  const auto give = [&](Quantity channel, double range_si, double noise_si) {
    Transducer& t = programme.transducers[static_cast<std::size_t>(channel)];
    t.range = range_si / t.unit.scale;
    t.step = converter_step(t.range, 12);
    t.noise_rms = noise_si / t.unit.scale;
  };
  give(Quantity::axial_displacement, 0.05, 1e-5);
  give(Quantity::axial_force, 5000, 3);
  for (const Quantity pressure :
       {Quantity::cell_pressure, Quantity::pore_pressure, Quantity::back_pressure})
    give(pressure, 2e6, 500);
  return programme;
}

}  // namespace

TEST_CASE("at held q, valve closed, the interval of q is narrow and knows of unmeasured swelling") {
  const Programme programme = without_errors_of_scale("csu_26");
  for (const std::uint64_t seed : {1U, 2U}) {
    const Judged j = judge(programme, seed);
    CHECK(j.at.q_pa.holds(j.q));
    CHECK(j.at.eta.holds(j.eta()));
    CHECK(j.at.q_pa.high - j.at.q_pa.low < 1e3);
    CHECK(j.at.eta.high - j.at.eta.low < 0.02);
  }
}

TEST_CASE("a loop that seeks the volume by a coarse transducer makes the interval wider") {
  const Programme programme = cheap("strain_path_070");
  for (const std::uint64_t seed : {1U, 3U, 4U}) {
    const Judged j = judge(programme, seed);
    CHECK(j.at.eta.holds(j.eta()));
    CHECK(j.at.q_pa.holds(j.q));
    CHECK(j.at.eta.high - j.at.eta.low < 0.1);
  }
}
