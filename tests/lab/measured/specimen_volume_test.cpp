// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/specimen_volume.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace triax::lab;

namespace {

const StageInfo kShear{
    .number = 2, .name = {}, .role = StageRole::shear, .drainage = Drainage::closed};
const StageInfo kHold{.number = 3, .name = {}, .role = StageRole::hold};
const SpecimenInfo kSpecimen{.height_m = 0.14, .diameter_m = 0.07};

State at(int stage, double u) {
  State s;
  s.stage = stage;
  s.p_eff = 1e5;
  s.q = 0;
  s.pore_pressure = u;
  s.effective_stress = {1e5, 1e5};
  s.volumetric_strain = 0.01;
  s.strain = {0.02, -0.005};
  return s;
}

}  // namespace

TEST_CASE("SpecimenVolume: a closed specimen changes its volume by c du") {
  SpecimenVolume volume(kSpecimen);
  CHECK(volume.with_fluid(at(2, 3e5), &kShear).volumetric_strain == Approx(0.01));
  const State later = volume.with_fluid(at(2, 4e5), &kShear);
  const double lines = 0.45e-12 / (std::numbers::pi / 4 * 0.07 * 0.07 * 0.14);
  CHECK(later.volumetric_strain - 0.01 == Approx((2.3e-10 + lines) * 1e5).epsilon(0.01));
  CHECK(later.strain.axial == 0.02);
  CHECK(later.pore_pressure == 4e5);
}

TEST_CASE("SpecimenVolume: c is fixed over the stages of shear and learned before") {
  SpecimenVolume volume(kSpecimen);
  CHECK_FALSE(volume.compliance());
  volume.with_fluid(at(2, 3e5), &kShear);
  const double before = volume.with_fluid(at(2, 4e5), &kShear).volumetric_strain;
  StageInfo next = kShear;
  next.number = 4;
  CHECK(volume.with_fluid(at(4, 4e5), &next).volumetric_strain == before);
  CHECK(volume.with_fluid(at(3, 3.5e5), &kHold).volumetric_strain == 0.01);
  CHECK_FALSE(volume.compliance());
  CHECK(volume.with_fluid(at(4, 3.5e5), &next).volumetric_strain == Approx(0.01));
}

TEST_CASE("SpecimenVolume: without a pore pressure the volume is as measured") {
  SpecimenVolume volume(kSpecimen);
  CHECK(volume.with_fluid(at(2, kMissing), &kShear).volumetric_strain == 0.01);
  CHECK_FALSE(volume.compliance());
}
