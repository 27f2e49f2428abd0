#include "lab/programmes/programme.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/virtual_rig.hpp"

using namespace triax;

namespace {

struct Expected {
  const char* name;
  double p0_kPa, e0;  // of Table 2, at the start of shear
  double eta;         // of the law at collapse (ICU or CSD path), 0: no collapse
};

// eta: SANISAND with S28-general on the bare path; CSU at the state that its own path reaches.
constexpr Expected kSamples[] = {
    {"icu_6", 100, 1.086, 0.588},  {"icu_42", 300, 1.060, 0.579}, {"csd_51", 100, 1.192, 0.553},
    {"csd_58", 300, 1.068, 0.578}, {"csd_60", 300, 1.161, 0.547}, {"csu_26", 300, 1.070, 0.573},
    {"csu_31", 100, 1.136, 0.567}, {"csu_27", 750, 1.136, 0.535}, {"icu_dense", 300, 0.75, 0},
};

}  // namespace

TEST_CASE("the sample programmes run to their end and lose sustainability where the law says") {
  for (const Expected& expected : kSamples) {
    INFO(expected.name);
    lab::VirtualRig rig(
        lab::load_programme(std::string("samples/programmes/") + expected.name + ".toml"));
    lab::Reading reading;
    double b_value = 0, cell_0 = 0, pore_0 = 0, p0 = 0, e0 = 0, lowest_u = 1e9, time_of_lowest = 0;
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
        p0 = state.material.p();
        e0 = state.material.void_ratio;
      } else if (state.pore_pressure < lowest_u) {
        lowest_u = state.pore_pressure;
        time_of_lowest = reading.time_s;
      }
      sheared = sheared || shear;
    }
    CHECK(sheared);
    CHECK(rig.header().warnings.empty());
    CHECK(reading.number > 1000);
    CHECK(reading.number < 20000);
    CHECK(b_value >= 0.96);
    CHECK(p0 / 1e3 == Approx(expected.p0_kPa).epsilon(0.01));
    CHECK(e0 == Approx(expected.e0).margin(5e-4));
    const lab::Truth truth = *rig.truth();
    CHECK(truth.lost_sustainability == (expected.eta > 0));
    if (expected.eta == 0) continue;
    CHECK(*truth.q_pa / *truth.p_eff_pa == Approx(expected.eta).margin(0.003));
    // Collapse leaves tens of readings behind it.
    CHECK(reading.time_s - *truth.time_s > 30);
    if (rig.header().programme == "CSU") {
      // The pore pressure falls until collapse and rises because of it.
      CHECK(time_of_lowest == Approx(*truth.time_s).margin(2));
      CHECK(rig.specimen_state().pore_pressure > lowest_u + 50e3);
    }
  }
}
