// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/programme.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax;

namespace {

struct Expected {
  const char* name;
  double p0_kPa, e0;  // of Table 2, at the start of shear
  double eta;         // of the law at collapse (ICU or CSD path), 0: no collapse
};

// eta: INL2 with S28-general at the end of the bare path (tests/sim/materials/interpolated_test),
// that of constant q for CSD, of constant volume for ICU and CSU.
constexpr Expected kSamples[] = {
    {"icu_6", 100, 1.086, 0.596},  {"icu_42", 300, 1.060, 0.583}, {"icu_7", 750, 1.083, 0.545},
    {"csd_51", 100, 1.192, 0.552}, {"csd_58", 300, 1.068, 0.586}, {"csd_60", 300, 1.161, 0.543},
    {"csu_31", 100, 1.136, 0.571}, {"csu_26", 300, 1.070, 0.578}, {"csu_41", 300, 1.101, 0.563},
    {"csu_27", 750, 1.136, 0.524}, {"csd_61", 100, 1.192, 0.552}, {"icu_dense", 300, 0.75, 0},
};

}  // namespace

TEST_CASE("the sample programmes run to their end and lose sustainability where the law says") {
  for (const Expected& expected : kSamples) {
    INFO(expected.name);
    const auto programme =
        lab::load_programme(std::string("samples/programmes/") + expected.name + ".toml");
    const bool by_load = lab::by_force(programme.stages.back().axial);
    lab::VirtualRig rig(programme);
    lab::Reading reading;
    double b_value = 0, cell_0 = 0, pore_0 = 0, p0 = 0, e0 = 0, lowest_u = 1e9, pore_at_shear = 0;
    bool sheared = false;
    while (rig.next(reading)) {
      const auto& state = rig.specimen_state();
      if (reading.number == 0) {
        cell_0 = state.cell_pressure;
        pore_0 = state.pore_pressure;
      }
      if (reading.stage == 1 && reading.number > 0)
        b_value = (state.pore_pressure - pore_0) / (state.cell_pressure - cell_0);
      const bool shear = rig.header().stage(reading.stage)->role == lab::StageRole::shear;
      if (!shear) {
        pore_at_shear = state.pore_pressure;
        p0 = state.material.p();
        e0 = state.material.void_ratio;
      } else {
        lowest_u = std::min(lowest_u, state.pore_pressure);
      }
      sheared = sheared || shear;
    }
    CHECK(sheared);
    CHECK(reading.number > 1000);
    CHECK(reading.number < 40000);
    CHECK(b_value >= 0.96);
    CHECK(p0 / 1e3 == Approx(expected.p0_kPa).epsilon(0.01));
    // e₀ of the table is the measured one: water that goes into lines counts as drained.
    CHECK(e0 == Approx(expected.e0).margin(1e-3));
    const lab::Truth truth = *rig.truth();
    CHECK(truth.lost_sustainability == (expected.eta > 0));
    if (!by_load) {
      CHECK(rig.header().warnings.empty());
      CHECK(truth.run_aways.empty());
    }
    if (expected.eta == 0) continue;
    CHECK(*truth.q_pa / *truth.p_eff_pa == Approx(expected.eta).margin(0.005));
    const double left =
        (reading.time_s - *truth.time_s) / programme.stages.back().logging.interval_s;
    CHECK(left > lab::VirtualRig::kSafeReadings - 1);
    if (!by_load) continue;
    // Under load it ends on the stop.
    REQUIRE_FALSE(truth.run_aways.empty());
    CHECK(truth.run_aways.back().end == lab::RunAwayEnd::end_of_travel);
    REQUIRE(rig.header().warnings.size() == 1);
    CHECK_THAT(rig.header().warnings[0].text, Catch::Contains("reached"));
    if (rig.header().programme != "CSU") continue;
    // The pore pressure falls until collapse and rises because of it.
    CHECK(*truth.pore_pressure_pa < lowest_u + 500);
    CHECK(pore_at_shear > lowest_u + 10e3);
    CHECK(rig.specimen_state().pore_pressure > lowest_u + 50e3);
  }
}
