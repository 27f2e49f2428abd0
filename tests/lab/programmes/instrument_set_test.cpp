// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/instrument_set.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/programmes/rig_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {
std::string rig_with(const std::string& set) {
  return "instruments = \"" + set + "\"\ndrainage_resistance_kPa_s_per_mm3 = 0.5\n";
}
}  // namespace

TEST_CASE("every set that ships is a rig") {
  for (const std::string name : {"ideal", "standard", "advanced"})
    CHECK(test::complaint_of_rig(rig_with(name)) == "accepted");
}

TEST_CASE("ideal instruments are those of a rig of which nothing is said") {
  const Programme ideal = test::with_rig(rig_with("ideal")), none = test::with_rig("");
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    const Transducer &a = ideal.transducers[i], &b = none.transducers[i];
    CHECK(a.range == b.range);
    CHECK(a.step == b.step);
    CHECK(a.noise_rms == b.noise_rms);
    CHECK(a.hysteresis == b.hysteresis);
  }
  CHECK(ideal.cell_controller.time_constant_s == 0);
  CHECK(ideal.frame.stiffness_n_per_m == 0);
  CHECK(ideal.frame.moving_mass_kg == none.frame.moving_mass_kg);
}

TEST_CASE("advanced instruments are finer than standard ones in everything") {
  const Programme fine = test::with_rig(rig_with("advanced")),
                  coarse = test::with_rig(rig_with("standard"));
  for (std::size_t i = 0; i < kRawQuantityCount; ++i) {
    INFO(quantities()[i].name);
    if (!fine.fitted[i] || !coarse.fitted[i]) continue;
    const Transducer &a = fine.transducers[i], &b = coarse.transducers[i];
    CHECK(a.step > 0);
    CHECK(a.step < b.step);
    CHECK(a.noise_rms <= b.noise_rms);
    CHECK(a.hysteresis <= b.hysteresis);
    CHECK(a.nonlinearity <= b.nonlinearity);
  }
  CHECK(fine.back_controller.pressure_resolution_pa == Approx(100));
  CHECK(coarse.back_controller.pressure_resolution_pa == Approx(1000));
  CHECK(fine.back_controller.time_constant_s < coarse.back_controller.time_constant_s);
  CHECK(fine.frame.stiffness_n_per_m > coarse.frame.stiffness_n_per_m);
}

TEST_CASE("an unknown set lists the known ones") {
  CHECK_THROWS_WITH(find_instruments("standart"), Contains("did you mean 'standard'?") &&
                                                      Contains("advanced") && Contains("ideal"));
}
