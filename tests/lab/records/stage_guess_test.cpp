// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stage_guess.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace triax::lab;
using Catch::Contains;
using enum triax::lab::Quantity;

namespace {

/// Rows of shear: `fill` sets what row i of 40 holds.
template <class Fill>
StageSummary shear(const Fill& fill) {
  StageSummary summary;
  for (int i = 0; i <= 40; ++i) {
    Row row;
    row.si.fill(kMissing);
    fill(row, i / 40.0);
    summary.add(row);
  }
  return summary;
}

Drainage found(const StageSummary& summary, const SpecimenInfo& specimen = {}) {
  return find_drainage(summary, specimen).drainage;
}

}  // namespace

TEST_CASE("a guess says what was taken, what speaks for it, and how to say otherwise") {
  StageSummary moved;
  moved.number = 5;
  for (const double x : {0.0, 1.0}) {
    Row row;
    row.si.fill(kMissing);
    row.si[index(Quantity::axial_displacement)] = x * 4.2e-3;
    row.si[index(Quantity::back_volume)] = 3e-9;
    moved.add(row);
  }
  const StageInfo shear{.number = 5,
                        .role = StageRole::shear,
                        .drainage = Drainage::closed,
                        .control = AxialControl::displacement};
  const Guess guess = stage_guess(moved, shear, {});
  CHECK(guess.what == "stage 5");
  CHECK(guess.taken == "shear, drainage closed, displacement prescribed");
  CHECK(guess.evidence == "changed: the displacement by 4.2 mm, the back volume by 0 mm3");
  CHECK(guess.remedy == "--set stages.5.role=... and --set stages.5.drainage=open");

  StageInfo unsaid = shear;
  unsaid.control = AxialControl::unknown;
  CHECK(stage_guess(moved, unsaid, {}).taken ==
        "shear, drainage closed, control of the axis unknown");
  CHECK(stage_guess(moved, unsaid, {}).remedy ==
        "--set stages.5.role=... and --set stages.5.drainage=open and "
        "--set stages.5.control=displacement, load or constant_q");

  const Guess drainage = drainage_guess({.number = 1, .drainage = Drainage::open}, "because");
  CHECK(drainage.taken == "open");
  CHECK(drainage.remedy == "--set stages.1.drainage=closed");
}

TEST_CASE("find_drainage: a constant radial stress is drained") {
  const auto by_p = shear([](Row& row, double x) {
    row.si[index(deviator_stress)] = 180e3 * x;
    row.si[index(mean_effective_stress)] = 100e3 + 60e3 * x;
  });
  CHECK(found(by_p) == Drainage::open);
  CHECK_THAT(find_drainage(by_p, {}).text, Catch::Contains("q changes by 180.0 kPa"));
  CHECK(found(shear([](Row& row, double x) {
          row.si[index(effective_axial_stress)] = 100e3 + 180e3 * x;
          row.si[index(effective_radial_stress)] = 100e3 + 1e3 * x;
          row.si[index(pore_pressure)] = 200e3 + 2e3 * x;
        })) == Drainage::open);
}

TEST_CASE("find_drainage: a pore pressure that moves under a constant cell is undrained") {
  CHECK(found(shear([](Row& row, double x) {
          row.si[index(deviator_stress)] = 100e3 * x;
          row.si[index(effective_radial_stress)] = 100e3 - 50e3 * x;
          row.si[index(pore_pressure)] = 200e3 + 50e3 * x;
        })) == Drainage::closed);
}

TEST_CASE("find_drainage: raw channels, with the force over the area") {
  SpecimenInfo specimen;
  specimen.diameter_m = 0.1;
  const double area = std::numbers::pi / 4 * 0.01;
  const auto raw = [&](double rise) {
    return shear([&](Row& row, double x) {
      row.si[index(axial_force)] = 150e3 * area * x;
      row.si[index(cell_pressure)] = 300e3;
      row.si[index(pore_pressure)] = 200e3 + rise * x;
    });
  };
  CHECK(found(raw(60e3), specimen) == Drainage::closed);
  CHECK(found(raw(1e3), specimen) == Drainage::open);
  CHECK(found(raw(8e3), specimen) == Drainage::unknown);
  CHECK(found(raw(60e3)) == Drainage::unknown);
}

TEST_CASE("find_drainage: the volumetric strain") {
  const auto by_volume = [](double strain) {
    return shear([&](Row& row, double x) {
      row.si[index(deviator_stress)] = 100e3 * x;
      row.si[index(mean_effective_stress)] = 100e3;
      row.si[index(volumetric_strain)] = strain * x;
    });
  };
  CHECK(found(by_volume(0.02)) == Drainage::open);
  CHECK(found(by_volume(0)) == Drainage::closed);
  CHECK(found(by_volume(5e-4)) == Drainage::unknown);
}

TEST_CASE("find_drainage: what does not tell") {
  CHECK(found(StageSummary{}) == Drainage::unknown);
  CHECK(found(shear([](Row& row, double x) {  // constant p': drained or undrained
          row.si[index(deviator_stress)] = 100e3 * x;
          row.si[index(mean_effective_stress)] = 100e3;
        })) == Drainage::unknown);
  CHECK(found(shear([](Row& row, double x) {  // hardly sheared
          row.si[index(deviator_stress)] = 3e3 * x;
          row.si[index(effective_radial_stress)] = 100e3;
        })) == Drainage::unknown);
  CHECK(found(shear([](Row& row, double x) {  // p total: q/3 up and u moves
          row.si[index(deviator_stress)] = 100e3 * x;
          row.si[index(mean_effective_stress)] = 100e3 + 100e3 * x / 3;
          row.si[index(pore_pressure)] = 50e3 * x;
        })) == Drainage::unknown);
}
