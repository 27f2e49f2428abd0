// SPDX-License-Identifier: GPL-3.0-or-later
// With every imperfection zero the apparatus is the bare material point: what the instruments say,
// reduced as a record is, against the law driven through the same increments without any rig.
// Energy and water balance at every tick, with and without imperfections.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "lab/reduction/reduction.hpp"
#include "lab/rig/rig_header.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "sim/point/point_driver.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax;
using namespace triax::lab::test;
using lab::Quantity;
using Control = sim::MixedControl<sim::Axisymmetric>;

namespace {

constexpr double kHeight = 0.14;
constexpr double kVolume = std::numbers::pi / 4 * 0.07 * 0.07 * kHeight;

const std::string kImperfectRig =
    "water_bulk_modulus_GPa = 2.2\nsystem_compliance_mm3_per_kPa = 0.5\n"
    "drainage_resistance_kPa_s_per_mm3 = 0.1\n[rig.frame]\nstiffness_kN_per_mm = 20.0\n"
    "moving_mass_kg = 5.0\ndamping_N_s_per_m = 20.0\ntravel_mm = 20.0\n";

/// Most of what is imperfect.
lab::Programme real_programme(const std::string& stages) {
  lab::Programme p = rig_programme(stages, kImperfectRig);
  p.specimen.membrane_thickness_m = 0.3e-3;
  p.specimen.membrane_young_modulus_pa = 1.4e6;
  p.specimen.membrane_penetration_m = 5e-6;
  return p;
}

struct Deviation {
  double q = 0, p = 0, void_ratio = 0, strain = 0;
  int readings = 0;
  double worst() const { return std::max({q, p, void_ratio, strain}); }
};

/// What the readings tell of two instants.
struct Increment {
  double axial_strain = 0, volumetric_strain = 0, cell_pa = 0;  ///< natural strains
  double cell_after_pa = 0;
  int stage = 1;
};

/// `control(increment, state)` is what a programme without a rig would do to the point.
template <class Drive>
Deviation deviation(const lab::Programme& p, const Drive& control) {
  lab::VirtualRig rig(p);
  lab::Reduction reduction(rig.header(), {});
  const auto& law = *p.material.material.axisymmetric;
  auto point = law.isotropic(p.initial_effective_stress_pa, p.void_ratio);
  double strain = 0;
  Deviation worst;
  lab::Reading before, now;
  const auto height = [](const lab::Reading& r) {
    return kHeight - r[Quantity::axial_displacement];
  };
  const auto volume = [](const lab::Reading& r) { return kVolume + r[Quantity::back_volume]; };
  const auto note = [](double& most, double is, double should, double size) {
    most = std::max(most, std::fabs(is - should) / size);
  };
  for (; rig.next(now); before = now) {
    const lab::State seen = reduction.reduce(now);
    if (now.number > 0) {
      Increment d;
      d.axial_strain = -std::log(height(now) / height(before));
      d.volumetric_strain = -std::log(volume(now) / volume(before));
      d.cell_pa = now[Quantity::cell_pressure] - before[Quantity::cell_pressure];
      d.cell_after_pa = now[Quantity::cell_pressure];
      d.stage = now.stage;
      const auto step = sim::advance_point(law, point, control(d, point));
      REQUIRE(step.outcome == sim::StepOutcome::accepted);
      point = step.state;
      strain += step.strain_increment(0);
    }
    note(worst.q, seen.q, point.q(), std::max(point.q(), 1e3));
    note(worst.p, seen.p_eff, point.p(), point.p());
    note(worst.void_ratio, seen.void_ratio, point.void_ratio, point.void_ratio);
    note(worst.strain, -std::log(height(now) / kHeight), strain, std::max(strain, 1e-3));
    ++worst.readings;
  }
  INFO("q " << worst.q << ", p' " << worst.p << ", e " << worst.void_ratio << ", strain "
            << worst.strain);
  CHECK(worst.worst() <= 1e-9);
  CHECK(worst.readings > 100);
  for (const auto& warning : rig.header().warnings) CHECK(warning.text.empty());
  return worst;
}

const std::string kDrainedShear =
    shear_stage("open", "displacement", "axial_rate_mm_per_min = 0.1", R"("q_kPa", above = 30.0)");
const std::string kLoweredCell = "cell_rate_kPa_per_min = -6.0";
const std::string kHighStressRatio = R"("stress_ratio", above = 0.5)";

std::string compression(const std::string& drainage) {
  return shear_stage(drainage, "displacement", "axial_rate_mm_per_min = 1.0",
                     R"("axial_strain_pct", above = 2.0)");
}

std::string strain_path(double R) {
  return shear_stage("open", "displacement",
                     "axial_rate_mm_per_min = 0.5\nstrain_path_R = " + std::to_string(R),
                     R"("axial_strain_pct", above = 0.4)");
}

}  // namespace

TEST_CASE("ideal rig: undrained and drained compression are those of the bare point") {
  for (const char* law : {"inl2/S28-general", "sanisand/S28-general"}) {
    INFO(law);
    deviation(rig_programme(compression("closed"), kIdealFrame, 0.25, law),
              [](const Increment& d, const auto&) { return Control::strain_path(d.axial_strain); });
    deviation(rig_programme(compression("open"), kIdealFrame, 0.25, law),
              [](const Increment& d, const auto&) {
                return Control::drained_compression(d.axial_strain);
              });
  }
}

TEST_CASE("ideal rig: constant shear with falling cell pressure is the bare point at constant q") {
  double held = 0;
  deviation(rig_programme(kDrainedShear +
                          shear_stage("open", "constant_q", kLoweredCell, kHighStressRatio)),
            [&](const Increment& d, const auto& point) {
              if (d.stage == 1) return Control::drained_compression(d.axial_strain);
              if (held == 0) held = point.q();
              return Control::stress_path(d.cell_pa, held - point.q());
            });
}

TEST_CASE("ideal rig: consolidation at a constant stress ratio is that of the bare point") {
  constexpr double kEta = 0.3;
  const std::string keys =
      "held_stress_ratio = 0.3\ncell_rate_kPa_per_min = 20.0\ncell_target_kPa = 500.0";
  deviation(rig_programme(stage_text("consolidation", "open", "stress_ratio", keys,
                                     R"("cell_pressure_kPa", above = 500.0)")),
            [](const Increment& d, const auto& point) {
              const double q = kEta * (d.cell_after_pa - 300e3) / (1 - kEta / 3);
              const double dq = q - point.q();
              return Control::stress_path(d.cell_pa + dq / 3, dq);
            });
}

TEST_CASE("ideal rig: proportional strain paths are those of the bare point") {
  for (const double R : {0.7, 1.3}) {
    INFO(R);
    deviation(rig_programme(strain_path(R)), [R](const Increment& d, const auto&) {
      return Control::strain_path(d.axial_strain, R);
    });
  }
}

namespace {

struct Balance {
  double energy = 0;  ///< largest part of a tick's work that is not accounted for
  double water = 0;   ///< largest part of the specimen's volume
  int ticks = 0, run_away = 0;
};

double turned_over(const sim::StepWork& w) {
  double sum = 0;
  for (const double part : {w.axial, w.cell, w.drainage, w.skeleton, w.membrane, w.water, w.damping,
                            w.stop, w.kinetic, w.impulse})
    sum += std::fabs(part);
  return sum;
}

/// Of ticks in which hardly anything happens, against the mean of the ticks so far.
Balance balance(const lab::Programme& programme) {
  lab::VirtualRig rig(programme);
  Balance worst;
  double sum = 0;
  for (lab::Reading r; rig.next(r);) {
    if (r.number == 0) continue;
    const sim::SpecimenStep& step = rig.plant().last_step();
    const double work = turned_over(step.work);
    sum += work;
    ++worst.ticks;
    worst.energy =
        std::max(worst.energy, std::fabs(step.work.balance()) / std::max(work, sum / worst.ticks));
    const auto& specimen = rig.plant().specimen();
    worst.water = std::max(worst.water, std::fabs(specimen.water_imbalance_m3(step.state)) /
                                            specimen.volume_m3(step.state));
    worst.run_away += step.ran_away ? 1 : 0;
  }
  return worst;
}

}  // namespace

TEST_CASE("energy and water balance at every tick of every kind of test") {
  const std::string csd =
      kDrainedShear + shear_stage("open", "constant_q", kLoweredCell, kHighStressRatio);
  const std::string csu = kDrainedShear + shear_stage("closed", "constant_q", kLoweredCell,
                                                      R"("time_min", above = 10.0)");
  for (const std::string& stages : {compression("closed"), csd, csu, strain_path(0.7)})
    for (const lab::Programme& programme : {rig_programme(stages), real_programme(stages)}) {
      INFO(stages << programme.frame.moving_mass_kg << " kg");
      const Balance quiet = balance(programme);
      CHECK(quiet.ticks > 200);
      CHECK(quiet.run_away == 0);
      CHECK(quiet.energy < 1e-5);  // of the trapezoid, in the first tick
      CHECK(quiet.water < 1e-12);
    }
  const Balance collapse = balance(real_programme(shear_stage(
      "closed", "load", "load_rate_N_per_min = 60.0", R"("axial_strain_pct", above = 12.0)")));
  CHECK(collapse.run_away > 0);
  CHECK(collapse.energy < 1e-3);
  CHECK(collapse.water < 1e-12);
}
