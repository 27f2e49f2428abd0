// SPDX-License-Identifier: GPL-3.0-or-later
// What the software of a rig does where its apparatus does not keep time. The rest of it is tried
// on the virtual rig.
#include "lab/rig/rig_software.hpp"

#include <functional>
#include <utility>

#include <catch2/catch.hpp>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/rig_header.hpp"
#include "lab/rig/simulated/virtual_apparatus.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;

namespace {

/// Time goes on by so much more at the tick that begins at 5 s.
class Stumbling : public Apparatus {
 public:
  Stumbling(const Programme& programme, double late_s) : inner_(programme, 1), late_s_(late_s) {}
  void look(Reading& reading) override { inner_.look(reading); }
  const DeviceStates& devices() const override { return inner_.devices(); }
  Ticked tick(const PlantDemand& demand, const Tick& tick) override {
    Ticked done = inner_.tick(demand, tick);
    if (tick.time_s == 5) done.passed_s += late_s_;
    return done;
  }
  void rest() override { ++rests; }
  int rests = 0;

 private:
  VirtualApparatus inner_;
  double late_s_;
};

/// An apparatus whose devices report what `change` makes of each look.
class Disturbed : public Apparatus {
 public:
  using Change = std::function<void(const Reading&, DeviceStates&)>;
  Disturbed(const Programme& programme, Change change)
      : inner_(programme, 1), change_(std::move(change)) {}
  void look(Reading& reading) override {
    inner_.look(reading);
    states_ = inner_.devices();
    change_(reading, states_);
  }
  const DeviceStates& devices() const override { return states_; }
  Ticked tick(const PlantDemand& demand, const Tick& tick) override {
    const Ticked done = inner_.tick(demand, tick);
    states_ = inner_.devices();
    return done;
  }

 private:
  VirtualApparatus inner_;
  Change change_;
  DeviceStates states_;
};

/// A ramp of the cell pressure from 400 kPa to 410 kPa in 10 s.
const char* const kRamp = R"(
[[stages]]
name = "ramp"
role = "consolidation"
drainage = "closed"
axial = "free"
cell_rate_kPa_per_min = 60.0
cell_target_kPa = 410.0
end = [{quantity = "cell_pressure_kPa", above = 410.0}]
)";

struct RampRun {
  double end_s = 0;
  std::vector<Check> checks;
};

/// Run with a cell controller that reports 4000 kPa from one instant until another.
RampRun run_ramp(double misread_from_s, double until_s) {
  const auto misread = [=](const Reading& reading, DeviceStates& states) {
    if (reading.time_s >= misread_from_s && reading.time_s < until_s) states.cell.asked_pa = 4000e3;
  };
  const GuardedProgramme all = with_guard_stages(read_programme(programme_text(kRamp), "p.toml"));
  RigSoftware rig(all, rig_header(all.programme, 1),
                  std::make_unique<Disturbed>(all.programme, misread));
  RampRun run;
  for (Reading reading; rig.next(reading);) run.end_s = reading.time_s;
  run.checks = rig.checks();
  return run;
}

struct SoftwareRun {
  std::vector<double> times_s;
  std::string told;
  int rests = 0;
};

SoftwareRun run_late(double late_s) {
  const GuardedProgramme all = with_guard_stages(read_programme(programme_text(), "p.toml"));
  auto apparatus = std::make_unique<Stumbling>(all.programme, late_s);
  const Stumbling& watched = *apparatus;
  RigSoftware rig(all, rig_header(all.programme, 1), std::move(apparatus));
  SoftwareRun run;
  for (Reading reading; run.times_s.size() < 12 && rig.next(reading);) {
    run.times_s.push_back(reading.time_s);
    for (const Event& event : rig.events()) run.told += event.detail;
  }
  rig.abort("enough");
  run.rests = watched.rests;
  return run;
}

}  // namespace

TEST_CASE("readings that were missed are told and not made up for") {
  const SoftwareRun late = run_late(2.5);
  CHECK(std::vector(late.times_s.begin() + 4, late.times_s.begin() + 10) ==
        std::vector<double>{4, 5, 7.75, 8, 9, 10});
  CHECK_THAT(late.told, Contains("readings are missed from 6 s to 7.75 s"));
  const SoftwareRun on_time = run_late(0);
  CHECK(on_time.times_s[8] == 8);
  CHECK(on_time.told.empty());
}

TEST_CASE("a test that is broken off brings its apparatus to rest") {
  CHECK(run_late(0).rests == 1);
}

TEST_CASE("RigSoftware: a fault has priority over the end of a stage", "[rig]") {
  const GuardedProgramme all = with_guard_stages(
      read_programme(replaced(programme_text(), R"("axial_strain_pct", above = 1.0)",
                              R"("time_min", above = 0.1)"),
                     "p.toml"));
  const auto fails_at_6_s = [](const Reading& reading, DeviceStates& states) {
    if (reading.time_s == 6) states.fault = "it stood still";
  };
  RigSoftware rig(all, rig_header(all.programme, 1),
                  std::make_unique<Disturbed>(all.programme, fails_at_6_s));
  for (Reading reading; rig.next(reading);) {
  }
  CHECK(rig.ending().kind == TestEnding::Kind::safe_state);
  CHECK_THAT(rig.ending().reason, Contains("it stood still"));
}

TEST_CASE("RigSoftware: one wrong set point of a controller ends no stage") {
  CHECK(run_ramp(100, 100).end_s == 10);
  for (const double from_s : {3.0, 4.0, 4.25}) CHECK(run_ramp(from_s, from_s + 0.25).end_s == 10);
  CHECK(run_ramp(100, 100).checks.empty());
}

TEST_CASE("RigSoftware: a stage that ends short of its target fails its check") {
  const RampRun run = run_ramp(0.75, 1e9);
  CHECK(run.end_s == 1);
  REQUIRE(run.checks.size() == 1);
  CHECK(run.checks[0].kind == CheckKind::stage_target);
  CHECK_FALSE(run.checks[0].ok);
  CHECK(run.checks[0].measured.value() == Approx(9).margin(0.1));
  CHECK(run.checks[0].limit == 8.2);
  CHECK_THAT(run.checks[0].note, Contains("stage \"ramp\" ended at a cell pressure of 401.0 kPa "
                                          "instead of its target of 410.0 kPa"));
}
