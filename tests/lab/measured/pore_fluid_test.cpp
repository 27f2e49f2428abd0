// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/pore_fluid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;

namespace {

constexpr double kAir = 8000;       ///< a, Pa
constexpr double kSkeleton = 3e-5;  ///< dε_v/d√p′, Pa^−½
constexpr double kAtmosphericPa = 101325;

const StageInfo kCheck{.number = 1, .name = {}, .role = StageRole::b_check};
const StageInfo kDrained{
    .number = 2, .name = {}, .role = StageRole::consolidation, .drainage = Drainage::open};

State before_shear(int stage, double p_eff, double u, double volume) {
  State s;
  s.stage = stage;
  s.p_eff = p_eff;
  s.q = 0;
  s.pore_pressure = u;
  s.effective_stress = {p_eff, p_eff};
  s.volumetric_strain = volume;
  s.strain = {volume / 3, volume / 3};
  return s;
}

/// Undrained, from p′ = 20 kPa and u = 300 kPa: a d(−1/P) = k d√p′.
void check(PoreFluid& fluid, double step_pa) {
  for (int i = 0; i <= 20; ++i) {
    const double u = 3e5 + step_pa * i / 20;
    const double root =
        std::sqrt(2e4) + kAir / kSkeleton * (1 / (3e5 + kAtmosphericPa) - 1 / (u + kAtmosphericPa));
    fluid.add(before_shear(1, root * root, u, 0), &kCheck);
  }
}

/// In two stages, each with strains of its own.
void consolidate(PoreFluid& fluid) {
  for (int stage = 2; stage <= 3; ++stage) {
    const double from = stage == 2 ? 2e4 : 6e4;
    for (int i = 0; i <= 20; ++i) {
      const double p = from + 2e3 * i;
      fluid.add(before_shear(stage, p, 3e5, kSkeleton * (std::sqrt(p) - std::sqrt(from))),
                &kDrained);
    }
  }
}

}  // namespace

TEST_CASE("what the pore fluid gives way comes back from B check and consolidation") {
  PoreFluid fluid;
  check(fluid, 8e4);
  consolidate(fluid);
  CHECK(fluid.air() == Approx(kAir).epsilon(1e-3));
}

TEST_CASE("a pore fluid of which a test shows nothing gives no way") {
  PoreFluid unchecked, unconsolidated, small;
  consolidate(unchecked);
  check(unconsolidated, 8e4);
  check(small, 2e3);
  consolidate(small);
  for (const PoreFluid& fluid : {unchecked, unconsolidated, small}) CHECK(fluid.air() == 0);
}

TEST_CASE(
    "where u falls in consolidation the fluid drives water out as it swells, and that is known") {
  // The B check is not taken back: u falls from 380 to 300 kPa as the specimen drains.
  PoreFluid fluid;
  check(fluid, 8e4);
  const auto swollen = [](double u) { return kAir / (u + kAtmosphericPa); };
  for (int i = 0; i <= 40; ++i) {
    const double u = 3.8e5 - 2e3 * i, p = 6.3e4 + 2e3 * i;
    const double out = kSkeleton * (std::sqrt(p) - std::sqrt(6.3e4)) + swollen(u) - swollen(3.8e5);
    fluid.add(before_shear(2, p, u, out), &kDrained);
  }
  CHECK(fluid.air() == Approx(kAir).epsilon(0.01));
}

TEST_CASE("the skeleton is that of the B check, not the one far above it") {
  PoreFluid near, far;
  check(near, 8e4);
  check(far, 8e4);
  for (int i = 0; i <= 200; ++i) {
    const double p = 2e4 + 4e3 * i,
                 bent = p < 1.2e5 ? std::sqrt(p) : 2 * std::sqrt(p) - std::sqrt(1.2e5);
    near.add(before_shear(2, p, 3e5, kSkeleton * std::sqrt(p)), &kDrained);
    far.add(before_shear(2, p, 3e5, kSkeleton * bent), &kDrained);
  }
  CHECK(far.air() == Approx(near.air()).epsilon(0.02));
}

TEST_CASE("(1 - B)/B is what the cell pressure did beside u") {
  PoreFluid fluid;
  CHECK_FALSE(fluid.give());
  check(fluid, 8e4);
  // σ₃ = p′ + u: of the same closed form
  const double root =
      std::sqrt(2e4) +
      kAir / kSkeleton * (1 / (3e5 + kAtmosphericPa) - 1 / (3.8e5 + kAtmosphericPa));
  REQUIRE(fluid.give());
  CHECK(*fluid.give() == Approx((root * root - 2e4) / 8e4));
}

TEST_CASE("PoreFluid: a good B check and consolidation outweigh what is known before") {
  PoreFluid fluid;
  check(fluid, 8e4);
  consolidate(fluid);
  const double u = 3e5, p_of_check = 3.8e5 + kAtmosphericPa;
  const FluidCompliance c = fluid.posterior(u, std::nullopt);
  // 3.5e-8/Pa, thirty times that of water and lines: the rest is free air.
  const double shown = kAir / (p_of_check * p_of_check);
  // An error of 0.3 c makes smaller values the likelier ones.
  CHECK(c.at(3.8e5) == Approx(shown).epsilon(0.25));
  CHECK(c.least * c.at(3.8e5) < shown);
  CHECK(c.most * c.at(3.8e5) > shown);
  CHECK(c.most / c.least < 5);
  CHECK(c.rigid == Approx(2.3e-10 + 0.45e-12 / 5.4e-4));
  CHECK(c.at(1e5) > 3 * c.at(5e5));
}

TEST_CASE("PoreFluid: without a B check c is that of water and lines") {
  const FluidCompliance large = PoreFluid().posterior(3e5, 5.4e-3);
  const FluidCompliance small = PoreFluid().posterior(3e5, 5.4e-4);
  CHECK(large.at(3e5) == Approx(2.3e-10 + 0.45e-12 / 5.4e-3).epsilon(0.01));
  CHECK(small.at(3e5) == Approx(2.3e-10 + 0.45e-12 / 5.4e-4).epsilon(0.01));
  CHECK(small.least == Approx(std::exp(-1.96 * 0.92)).epsilon(0.02));
  CHECK(small.most == Approx(std::exp(1.96 * 0.92)).epsilon(0.02));
}

TEST_CASE("PoreFluid: a B check by two transducers that differ shows little") {
  // B reads 1.001: the fluid would expand under pressure.
  PoreFluid fluid;
  for (int i = 0; i <= 20; ++i) fluid.add(before_shear(1, 2e4 - 4 * i, 3e5 + 4e3 * i, 0), &kCheck);
  consolidate(fluid);
  const FluidCompliance c = fluid.posterior(3e5, std::nullopt);
  CHECK(c.at(3e5) > 0);
  CHECK(c.at(3e5) < 2e-9);
  CHECK(c.least > 0);
}

TEST_CASE("FluidCompliance: the strain is the integral of c") {
  const FluidCompliance c{.rigid = 1e-9, .air = 500};
  const double u = 2.5e5, step = 10;
  CHECK((c.strain(u + step) - c.strain(u - step)) / (2 * step) == Approx(c.at(u)).epsilon(1e-6));
}
