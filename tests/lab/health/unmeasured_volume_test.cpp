// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/unmeasured_volume.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;
using Catch::Contains;

namespace {

RecordHeader header_of(Drainage drainage, AxialControl control = AxialControl::displacement) {
  RecordHeader header;
  header.columns = {Quantity::axial_strain, Quantity::deviator_stress,
                    Quantity::mean_effective_stress};
  StageInfo stage;
  stage.role = StageRole::shear;
  stage.drainage = drainage;
  stage.control = control;
  header.stages = {stage};
  return header;
}

State at(double q, double radial, double strain) {
  State s;
  s.q = q;
  s.p_eff = radial + q / 3;
  s.effective_stress = {radial + q, radial};
  s.strain.axial = strain;
  return s;
}

}  // namespace

TEST_CASE("UnmeasuredVolume: a constant radial stress needs no volume") {
  UnmeasuredVolume volume(header_of(Drainage::open));
  volume.completed(at(0, 100e3, 0));
  const State whole = volume.completed(at(150e3, 103e3, 0.04));
  CHECK(whole.volumetric_strain == 0);
  CHECK(whole.strain.radial == Approx(-0.02));
  CHECK(volume.reason(whole).empty());
}

TEST_CASE("UnmeasuredVolume: a radial stress that moves does") {
  UnmeasuredVolume volume(header_of(Drainage::open));
  volume.completed(at(0, 100e3, 0));
  const State moved = volume.completed(at(50e3, 80e3, 0.04));
  CHECK(std::isnan(moved.volumetric_strain));
  CHECK_THAT(volume.reason(moved), Contains("from 100.0 kPa to 80.0 kPa"));
  UnmeasuredVolume held(header_of(Drainage::open, AxialControl::constant_q));
  CHECK_THAT(held.reason(held.completed(at(50e3, 100e3, 0))), Contains("prescribed load or q"));
}

TEST_CASE("UnmeasuredVolume: states with a volume, or of a record that has one") {
  UnmeasuredVolume volume(header_of(Drainage::open));
  State measured = at(50e3, 100e3, 0.01);
  measured.volumetric_strain = 0.003;
  CHECK(volume.completed(measured).volumetric_strain == 0.003);
  auto header = header_of(Drainage::open);
  header.columns.push_back(Quantity::volumetric_strain);
  UnmeasuredVolume gap(header);  // one value is missing: nothing is put in its place
  const State missing = gap.completed(at(50e3, 100e3, 0.01));
  CHECK(std::isnan(missing.volumetric_strain));
  CHECK(gap.reason(missing).empty());
}
