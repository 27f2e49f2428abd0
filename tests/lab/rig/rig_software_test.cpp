// SPDX-License-Identifier: GPL-3.0-or-later
// What the software of a rig does where its apparatus does not keep time. The rest of it is tried
// on the virtual rig.
#include "lab/rig/rig_software.hpp"

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
  CHECK_THAT(late.told, Contains("readings are missed from 6 s on"));
  const SoftwareRun on_time = run_late(0);
  CHECK(on_time.times_s[8] == 8);
  CHECK(on_time.told.empty());
}

TEST_CASE("a test that is broken off brings its apparatus to rest") {
  CHECK(run_late(0).rests == 1);
}
