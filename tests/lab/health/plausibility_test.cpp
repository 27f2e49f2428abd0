// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/plausibility.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;
using Catch::Contains;

namespace {

State at(std::int64_t reading, double q_kPa, double p_kPa, double axial_strain) {
  State s;
  s.reading = reading;
  s.q = q_kPa * 1e3;
  s.p_eff = p_kPa * 1e3;
  s.strain = {axial_strain, -axial_strain / 2};
  return s;
}

}  // namespace

TEST_CASE("a sound test passes, in compression, in extension and when it liquefies") {
  for (const double sign : {1.0, -0.7}) {
    Plausibility p({});
    for (int i = 0; i <= 100; ++i) CHECK(p.add(at(i, sign * i, 100, i * 1e-3)));
    CHECK(p.add(at(101, sign * 8, 2, 0.12)));  // q/p' of 4 where p' is all but gone
    CHECK(p.impossible_count() == 0);
    CHECK(p.idle().empty());
    CHECK(p.warnings().empty());
  }
}

TEST_CASE("pressures in another unit are not judged") {
  for (const double p0_kPa : {39763e2, 0.2}) {
    Plausibility p({});
    CHECK_FALSE(p.add(at(0, 0, p0_kPa, 0)));
    CHECK_THAT(p.warnings().at(0).text, Contains("another unit"));
  }
}

TEST_CASE("Plausibility: states beyond every limit surface are impossible", "[health]") {
  const auto possible = [](double q_kPa, double p_kPa) {
    Plausibility p({});
    REQUIRE(p.add(at(0, 0, 100, 0)));
    const bool passed = p.add(at(1, q_kPa, p_kPa, 0.01));
    CHECK(passed == p.impossible(at(1, q_kPa, p_kPa, 0.01)).empty());
    CHECK(passed == p.warnings().empty());
    return passed;
  };
  CHECK(possible(200, 100));
  CHECK(possible(-120, 100));
  CHECK_FALSE(possible(320, 100));
  CHECK_FALSE(possible(-149, 100));
  CHECK_FALSE(possible(0, -6));
  CHECK_FALSE(possible(-200, -100));  // q/p' of 2
  CHECK_FALSE(possible(50, -6628));
  CHECK(possible(8, 2));  // zeros are off by up to 5 kPa
  CHECK(possible(1, -3));
}

TEST_CASE("Plausibility: an impossible state counts for nothing after it", "[health]") {
  Plausibility p({});
  CHECK_FALSE(p.add(at(0, 0, -9999, 0)));
  CHECK(p.add(at(1, 0, 100, 0)));
  CHECK_FALSE(p.add(at(2, 0, -6000, 0.001)));
  CHECK(p.add(at(3, 100, 100, 0.002)));
  CHECK(p.impossible_count() == 2);
  REQUIRE(p.warnings().size() == 1);
  CHECK_THAT(p.warnings()[0].text,
             Contains("2 impossible states, not used, the last at reading 2") &&
                 Contains("-9999 kPa at reading 0"));
}

TEST_CASE("Plausibility: error of the zeros by p' at the start", "[health]") {
  CHECK(Plausibility::zero_error(1e6) == 20e3);
  CHECK(Plausibility::zero_error(100e3) == 5e3);
  CHECK(Plausibility::zero_error(20e3) == 2e3);
}

TEST_CASE("a force a thousand times too small is noticed at the end") {
  Plausibility p({});
  for (int i = 0; i <= 100; ++i) p.add(at(i, i * 1e-3, 100, i * 1e-3));
  CHECK_THAT(p.idle(), Contains("force"));
  Plausibility isotropic({});  // hardly sheared: nothing is wrong
  for (int i = 0; i <= 100; ++i) isotropic.add(at(i, 0, 100, i * 1e-5));
  CHECK(isotropic.idle().empty());
}

TEST_CASE("a load cell that begins below zero and steep angles are told") {
  Plausibility p({});
  p.add(at(0, -19.6, 100, 0));
  p.add(at(1, 250, 100, 0.01));
  const auto warnings = p.warnings();
  REQUIRE(warnings.size() == 2);
  CHECK_THAT(warnings[0].text, Contains("-19.6 kPa"));
  CHECK_THAT(warnings[1].text, Contains("friction angle"));
}

TEST_CASE("Plausibility: a q at the start that nothing applied is reported", "[health]") {
  const auto warnings = [](bool begins_unloaded, std::initializer_list<double> consolidation_kPa) {
    Plausibility p({}, begins_unloaded);
    for (const double q : consolidation_kPa) p.add_consolidation(q * 1e3);
    p.add(at(0, 44, 200, 0));
    p.add(at(1, 90, 220, 0.01));
    return p.warnings();
  };
  for (const auto& found : {warnings(true, {}), warnings(true, {43, 43.5, 44})}) {
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].text, Contains("q is 44.0 kPa at the start of shear and is used as it is"));
  }
  CHECK(warnings(true, {0, 20, 44}).empty());  // applied
  CHECK(warnings(false, {}).empty());
}

TEST_CASE("Plausibility: a steep stress ratio is explained by cohesion", "[health]") {
  const auto warnings_of = [](double q_kPa, double cohesion_kPa) {
    SpecimenInfo specimen;
    if (cohesion_kPa > 0) specimen.cohesion_pa = cohesion_kPa * 1e3;
    Plausibility p(specimen);
    REQUIRE(p.add(at(0, 0, 100, 0)));
    p.add(at(1, q_kPa, 100, 0.01));
    std::string text;
    for (const auto& warning : p.warnings()) text += warning.text;
    return text;
  };
  CHECK(warnings_of(200, 0).empty());
  CHECK_THAT(warnings_of(220, 0),
             Contains("over-consolidated clay") && Contains("cohesion_kPa") && !Contains("unit"));
  CHECK_THAT(warnings_of(290, 0), Contains("more than friction alone") && !Contains("unit"));
  CHECK_THAT(warnings_of(320, 0), Contains("below zero"));
  CHECK(warnings_of(220, 30).empty());
  CHECK_THAT(warnings_of(290, 30), Contains("larger than stated"));
  CHECK_THAT(warnings_of(320, 30), Contains("below zero"));
}

TEST_CASE("Plausibility: stresses of rock, where its cohesion is given", "[health]") {
  SpecimenInfo rock;
  rock.cohesion_pa = 30e6;
  for (const auto& specimen : {SpecimenInfo{}, rock}) {
    Plausibility p(specimen);
    REQUIRE(p.add(at(0, 0, 20e3, 0)));
    CHECK(p.add(at(1, 200e3, 90e3, 0.01)) == specimen.cohesion_pa.has_value());
  }
}

TEST_CASE("a specimen that no cell holds: a height or a diameter in another unit") {
  const auto possible = [](double height_mm, double diameter_mm) {
    SpecimenInfo specimen;
    specimen.height_m = height_mm / 1e3;
    specimen.diameter_m = diameter_mm / 1e3;
    const bool passed = Plausibility(specimen).impossible_specimen().empty();
    return passed;
  };
  CHECK(possible(140, 70));
  CHECK(possible(70, 70));  // lubricated ends
  CHECK(possible(76, 38));
  CHECK_FALSE(possible(14, 70));
  CHECK_FALSE(possible(1400, 70));
}

TEST_CASE("strain that runs against q: the sign of one of the two is wrong") {
  const auto reason = [](double sign, double q0, double q_end) {
    Plausibility p({});
    for (int i = 0; i <= 100; ++i)
      p.add(at(i, q0 + (q_end - q0) * i / 100.0, 100, sign * i * 1e-4));
    return p.backwards();
  };
  CHECK(reason(1, 0, 100).empty());
  CHECK(reason(-1, 0, -60).empty());  // extension
  CHECK_THAT(reason(-1, 0, 100), Contains("sign"));
  CHECK_THAT(reason(1, 0, -60), Contains("sign"));
  CHECK(reason(-1, 100, -60).empty());  // from a K0 state into extension
  CHECK(reason(-1, 100, 20).empty());   // unloading
}

TEST_CASE("stresses beyond any cell are in another unit, wherever they come") {
  Plausibility p({});
  CHECK(p.add(at(0, 0, 200, 0)));
  CHECK_FALSE(p.add(at(1, 122002, 141000, 0.01)));
  CHECK_THAT(p.warnings().at(0).text, Contains("another unit"));
}

TEST_CASE(
    "q that falls at a growing stress ratio while the strain goes back: a gauge that slipped") {
  const auto run = [](double sign, double p_end_kPa, double strain_end) {
    Plausibility p({});
    for (int i = 0; i <= 50; ++i) p.add(at(i, sign * 2.0 * i, 200 - i, sign * i * 1e-4));
    for (int i = 1; i <= 40; ++i)
      p.add(at(50 + i, sign * (100 - 2 * i), 150 + (p_end_kPa - 150) * i / 40.0,
               sign * (5e-3 + (strain_end - 5e-3) * i / 40.0)));
    return p.slip();
  };
  for (const double sign : {1.0, -1.0}) {
    REQUIRE(run(sign, 25, 3e-3));
    CHECK(run(sign, 25, 3e-3)->last == 50);
    CHECK_FALSE(run(sign, 140, 3e-3));  // unloading
    CHECK_FALSE(run(sign, 25, 0.1));    // a flow with its strain
  }
}
