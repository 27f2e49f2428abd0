// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/reduction.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lab/base/bad_input.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;
using triax::lab::testing::raw_header;
using triax::lab::testing::reading;

namespace {

constexpr double kArea = std::numbers::pi * 0.035 * 0.035;
constexpr double kVolume = kArea * 0.140;

}  // namespace

TEST_CASE("B is the pore pressure's answer to the cell pressure, and 0.96 is asked") {
  Reduction reduction(raw_header(), {});
  reduction.reduce(reading({1, 0, 0, 100, 50, 0}));
  reduction.reduce(reading({1, 0, 0, 150, 98.5, 0}, 1));
  CHECK(*reduction.consolidation().b_value == Approx(0.97));
  REQUIRE(reduction.checks(false).size() == 1);
  CHECK(reduction.checks(false)[0].ok);

  Reduction soft(raw_header(), {});
  soft.reduce(reading({1, 0, 0, 100, 50, 0}));
  soft.reduce(reading({1, 0, 0, 150, 86.65, 0}, 1));
  CHECK(*soft.consolidation().b_value == Approx(0.733));
  CHECK_FALSE(soft.checks(false)[0].ok);
}

TEST_CASE("consolidated dimensions, void ratio and the drained right cylinder") {
  Reduction reduction(raw_header(), {});
  reduction.reduce(reading({2, 0, 0, 400, 300, 100}));
  reduction.reduce(reading({2, 0.7, 0, 400, 300, 100 - 8000}, 1));  // 8000 mm3 driven out
  const double height = 0.1393, volume = kVolume - 8000e-9;
  const State start = reduction.reduce(reading({3, 0.7, 0, 400, 300, -7900}, 2));
  const Consolidation c = reduction.consolidation();
  CHECK(*c.height_m == Approx(height));
  CHECK(*c.diameter_m == Approx(std::sqrt(4 * volume / height / std::numbers::pi)));
  CHECK(*c.void_ratio == Approx(2.1 * volume / kVolume - 1));
  CHECK(*c.p_eff_pa == Approx(100e3));
  CHECK(start.strain.axial == Approx(0).margin(1e-12));

  const State s = reduction.reduce(reading({3, 2.7, 0.3, 410, 302, -7900 - 1500}, 3));
  const double axial = 0.002 / height, volumetric = 1500e-9 / volume;
  const double area = volume / height * (1 - volumetric) / (1 - axial);
  CHECK(s.strain.axial == Approx(axial));
  CHECK(s.volumetric_strain == Approx(volumetric));
  CHECK(s.area_m2 == Approx(area));
  CHECK(s.q == Approx(300 / area));
  CHECK(s.effective_stress.radial == Approx(108e3));
  CHECK(s.p_eff == Approx(108e3 + s.q / 3));
  CHECK(s.void_ratio == Approx(*c.void_ratio - volumetric * (1 + *c.void_ratio)));
  CHECK(s.phi_mob_rad() == Approx(std::asin(3 * s.eta() / (6 + s.eta()))));
}

TEST_CASE(
    "a displacement that stands still during consolidation means isotropic strain, and says so") {
  Reduction reduction(raw_header(), {});
  reduction.reduce(reading({2, 0, 0, 400, 300, 0}));
  reduction.reduce(reading({2, 0, 0, 400, 300, -8000}, 1));
  reduction.reduce(reading({3, 0, 0, 400, 300, -8000}, 2));
  CHECK(*reduction.consolidation().height_m ==
        Approx(0.140 * std::cbrt((kVolume - 8000e-9) / kVolume)));
  REQUIRE(reduction.warnings().size() == 1);
  CHECK(reduction.warnings()[0].text.find("isotropic") != std::string::npos);
}

TEST_CASE("a height typed in for the start of shear is taken") {
  RecordHeader header = raw_header();
  header.specimen.consolidated_height_m = 0.1370;
  Reduction reduction(header, {});
  reduction.reduce(reading({2, 0, 0, 400, 300, 0}));
  reduction.reduce(reading({2, 2.9, 0, 400, 300, -2000}, 1));
  reduction.reduce(reading({3, 0, 0, 400, 300, -2000}, 2));
  CHECK(*reduction.consolidation().height_m == Approx(0.1370));
  CHECK(reduction.reduce(reading({3, 13.70, 0, 400, 300, -2000}, 3)).strain.axial == Approx(0.1));
}

TEST_CASE("water that saturates the specimen does not change its volume") {
  RecordHeader header = raw_header();
  header.stages[0].role = StageRole::saturation;
  Reduction reduction(header, {});
  reduction.reduce(reading({1, 0, 0, 100, 50, 0}));
  const State s = reduction.reduce(reading({1, 0, 0, 150, 98, 10000}, 1));
  CHECK(s.volumetric_strain == 0);
  reduction.reduce(reading({3, 0, 0, 150, 98, 10000}, 2));
  CHECK(*reduction.consolidation().void_ratio == Approx(1.1));
}

TEST_CASE("membrane: 1400 kPa, 0.3 mm, 70 mm at 10 % take 2.4 kPa off q") {
  RecordHeader header = raw_header();
  header.stages = {{.number = 3, .role = StageRole::shear, .drainage = Drainage::closed}};
  header.specimen.membrane_thickness_m = 0.3e-3;
  header.specimen.membrane_modulus_pa = 1400e3;
  const auto q_with = [&](MembraneCorrection membrane) {
    Reduction reduction(header, {.membrane = membrane});
    reduction.reduce(reading({3, 0, 0, 400, 300, 0}));
    return reduction.reduce(reading({3, 14, 0.2, 400, 300, 0}, 1)).q;
  };
  const double none = q_with(MembraneCorrection::none);
  CHECK(none - q_with(MembraneCorrection::astm) == Approx(2.4e3));
  CHECK(none - q_with(MembraneCorrection::iso) == Approx(2.4e3));
  header.specimen.membrane_modulus_pa.reset();
  CHECK_THROWS_WITH(q_with(MembraneCorrection::iso), Catch::Contains("membrane_modulus_kPa"));
}

TEST_CASE("what is missing or impossible is said with the key or the line") {
  RecordHeader header = raw_header();
  header.specimen.height_m.reset();
  CHECK_THROWS_WITH(Reduction(header, {}), Catch::Contains("--set specimen.height_mm"));
  Reduction reduction(raw_header(), {});
  reduction.reduce(reading({3, 0, 0, 400, 300, 0}));
  const auto far = [&](std::int64_t i) {
    return reduction.reduce(reading({3, 150, 0, 400, 300, 0}, i));
  };
  for (std::int64_t i = 7; i < 7 + Reduction::kMostImpossible; ++i)
    CHECK(std::isnan(far(i).strain.axial));
  CHECK_THROWS_WITH(far(7 + Reduction::kMostImpossible),
                    Catch::Contains("test.csv:9") && Catch::Contains("check the units"));
}

TEST_CASE("Reduction: a few impossible strains are unknown states and a warning", "[reduction]") {
  Reduction reduction(raw_header(), {});
  const auto strain_at = [&](std::int64_t i, double displacement_mm) {
    return reduction.reduce(reading({3, displacement_mm, 0, 400, 300, 0}, i)).strain.axial;
  };
  strain_at(0, 0);
  const auto warnings = reduction.warnings().size();
  CHECK(std::isnan(strain_at(1, 9000)));
  CHECK(std::isnan(strain_at(2, -150)));
  CHECK(strain_at(3, 1.4) == Approx(0.01));
  REQUIRE(reduction.warnings().size() == warnings + 1);
  CHECK(reduction.warnings().back().line == 3);
  CHECK_THAT(reduction.warnings().back().text,
             Catch::Contains("axial strain 64.3") && Catch::EndsWith("(and 1 more)"));
}

TEST_CASE("Reduction: a missing displacement in shear is no old one", "[reduction]") {
  Reduction reduction(raw_header(), {});
  Reading r = reading({3, 5, 0.1, 400, 300, 0}, 0);
  r[Quantity::axial_displacement] = kMissing;
  r[Quantity::back_volume] = kMissing;
  CHECK(std::isnan(reduction.reduce(r).strain.axial));
  CHECK(reduction.reduce(reading({3, 5, 0.1, 400, 300, 900}, 1)).strain.axial == 0);
  CHECK(reduction.reduce(reading({3, 6.4, 0.1, 400, 300, 900}, 2)).strain.axial == Approx(0.01));
  CHECK(reduction.reduce(reading({3, 6.4, 0.1, 400, 300, 900}, 3)).volumetric_strain == 0);
  r.number = 4;
  CHECK(std::isnan(reduction.reduce(r).q));
}

TEST_CASE("the file's own q is compared with ours, and the area named as the cause") {
  RecordHeader header = raw_header();
  header.stages = {{.number = 3, .role = StageRole::shear, .drainage = Drainage::closed}};
  Reduction reduction(header, {});
  for (int i = 0; i < 20; ++i) {
    Reading r = reading({3, 0.1 * i, 0.01 * i, 400, 300, 0}, i);
    const double area = kArea / (1 - 0.1e-3 * i / 0.140);
    r[Quantity::current_area] = 0.95 * area;
    r[Quantity::deviator_stress] = 10.0 * i / (0.95 * area);
    reduction.reduce(r);
  }
  REQUIRE(reduction.checks(true).size() == 2);
  const Check check = reduction.checks(true)[0];
  CHECK(*check.measured == Approx(1 - 1 / 0.95));
  CHECK_FALSE(check.ok);
  CHECK(check.note.find("area") != std::string::npos);
  CHECK(check.note.find("counter") != std::string::npos);
}

TEST_CASE("reduced columns enter at State; effective stresses come before computed ones") {
  RecordHeader header;
  header.columns = {Quantity::axial_strain, Quantity::effective_axial_stress,
                    Quantity::effective_radial_stress, Quantity::deviator_stress};
  header.specimen.void_ratio = 0.97;
  Reduction reduction(header, {});
  Reading r;
  r[Quantity::axial_strain] = 0.01;
  r[Quantity::effective_axial_stress] = 150e3;
  r[Quantity::effective_radial_stress] = 90e3;
  r[Quantity::deviator_stress] = 61e3;
  r[Quantity::volumetric_strain] = 0.002;
  const State s = reduction.reduce(r);
  CHECK(s.q == Approx(60e3));
  CHECK(s.p_eff == Approx(110e3));
  CHECK(s.strain.radial == Approx(-0.004));
  CHECK(s.void_ratio == Approx(0.97 - 0.002 * 1.97));
  CHECK(*reduction.consolidation().p_eff_pa == Approx(110e3));
  CHECK(reduction.warnings().size() == 2);  // reduced; no volume in the heading

  Reading pq;  // p' and q alone
  pq[Quantity::axial_strain] = 0.02;
  pq[Quantity::deviator_stress] = 45e3;
  pq[Quantity::mean_effective_stress] = 100e3;
  CHECK(reduction.reduce(pq).effective_stress.radial == Approx(85e3));
}

TEST_CASE("a raw record without pore and back pressure has no effective stress") {
  RecordHeader header = raw_header();
  std::erase(header.columns, Quantity::back_pressure);
  CHECK_NOTHROW(Reduction(header, {}));
  std::erase(header.columns, Quantity::pore_pressure);
  CHECK_THROWS_WITH(Reduction(header, {}), Catch::Contains("pore_pressure_kPa"));
}
