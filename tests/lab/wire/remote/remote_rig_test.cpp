// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a programme on a served rig give the test that the virtual rig gives, and what goes
// wrong on the wire is told and never made up for.
#include "lab/wire/remote/remote_rig.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <thread>

#include "lab/base/bad_input.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "tests/lab/wire/served_bench.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;

namespace {

std::vector<Reading> readings_of(BackEnd& rig, std::size_t most = 100'000) {
  std::vector<Reading> all;
  for (Reading one; all.size() < most && rig.next(one);) all.push_back(one);
  return all;
}

/// Half a digit of what is printed, at most: far below half a step of any converter.
bool same(double a, double b) {
  return std::isnan(a) == std::isnan(b) &&
         (std::isnan(a) || std::fabs(a - b) <= 5e-9 * std::max(1e-6, std::fabs(b)));
}

void check_same(const std::vector<Reading>& remote, const std::vector<Reading>& direct) {
  REQUIRE(remote.size() == direct.size());
  REQUIRE(remote.size() > 30);
  for (std::size_t i = 0; i < remote.size(); ++i) {
    INFO("reading " << i);
    REQUIRE(remote[i].time_s == direct[i].time_s);
    REQUIRE(remote[i].stage == direct[i].stage);
    for (const auto& row : raw_channels()) {
      INFO(row.name << " " << remote[i][row.quantity] << " " << direct[i][row.quantity]);
      REQUIRE(same(remote[i][row.quantity], direct[i][row.quantity]));
    }
  }
}

void check_lock_step(const Programme& programme, const std::string& link) {
  const ServedBench bench(programme, rig_text(link), {.lock_step = true});
  LineLoop loop;
  RemoteRig remote(loop, bench.client, programme);
  VirtualRig direct(programme);
  check_same(readings_of(remote), readings_of(direct));
  CHECK(remote.header().cut_short == direct.header().cut_short);
}

const char* const kStandard =
    "back_pressure_kPa = 300.0\ninstruments = \"standard\"\n"
    "drainage_resistance_kPa_s_per_mm3 = 0.5\n";

/// Pressures, valve and force are all driven: a B check, drained shear, constant q.
const char* const kConstantQ = R"(
[[stages]]
name = "B check"
role = "b_check"
drainage = "closed"
axial = "free"
cell_rate_kPa_per_min = 60.0
cell_target_kPa = 410.0
end = [{quantity = "cell_pressure_kPa", above = 410.0}]
[[stages]]
name = "drained shear"
role = "shear"
drainage = "open"
axial = "displacement"
axial_rate_mm_per_min = 1.0
end = [{quantity = "q_kPa", above = 20.0}]
[[stages]]
name = "constant q"
role = "shear"
drainage = "open"
axial = "constant_q"
back_rate_kPa_per_min = 60.0
end = [{quantity = "time_min", above = 0.5}]
)";

}  // namespace

TEST_CASE("in lock step a test over the wire is the simulated one, reading by reading") {
  const Programme crosshead = read_programme(programme_text(), "p.toml");
  const Programme force = read_programme(programme_text(kConstantQ, kStandard), "p.toml");
  SECTION("SCPI") { check_lock_step(crosshead, "tcp://127.0.0.1:0"); }
  SECTION("Modbus") { check_lock_step(crosshead, "modbus-tcp://127.0.0.1:0/7"); }
  SECTION("pressures and force, SCPI") { check_lock_step(force, "tcp://127.0.0.1:0"); }
}

TEST_CASE("what stands on the wire says that it is simulated, and so does the record") {
  const Programme programme = read_programme(programme_text(), "p.toml");
  const ServedBench bench(programme, rig_text(), {.lock_step = true});
  LineLoop loop;
  RemoteRig remote(loop, bench.client, programme);
  CHECK(remote.header().origin == Origin::simulated);
  REQUIRE(remote.header().notes.size() == 5);
  CHECK(remote.header().notes[1].label == "instrument scanner");
  CHECK_THAT(remote.header().notes[1].text,
             Contains("34970A") && Contains("axial_force: gain = 1000") && Contains("2026-03-17"));
}

TEST_CASE("an instrument that is away or another one is named before the test begins") {
  const Programme programme = read_programme(programme_text(), "p.toml");
  const ServedBench bench(programme, rig_text(), {.lock_step = true});
  LineLoop loop;
  ControlLine control(loop, *bench.client.plant->control);
  SECTION("another one") {
    tell(control, "LINE:PRET \"frame\",ON");
    RemoteApparatus apparatus(loop, bench.client, programme);
    CHECK_THROWS_WITH(apparatus.connect(0.5), Contains("frame") && Contains("somebody,else"));
  }
  SECTION("away") {
    tell(control, "LINE:FAULT \"cell\",REFUSE");
    RemoteApparatus apparatus(loop, bench.client, programme);
    CHECK_THROWS_WITH(apparatus.connect(0.5), Contains("cell") && Contains("refused"));
  }
}

TEST_CASE("a rig that lacks what a test needs is refused with all that is missing") {
  const Programme programme = read_programme(programme_text(), "p.toml");
  const RigFile rig = parse_rig_file(
      replaced(replaced(rig_text(), "\nrole = \"frame\"", ""), "axial_force", "room"), "rig.toml");
  LineLoop loop;
  CHECK_THROWS_WITH(RemoteApparatus(loop, rig, programme),
                    Contains("role = \"frame\"") && Contains("a channel for axial_force"));
}

TEST_CASE("a channel that falls silent is missing, told, and leads to the safe state within 3 s") {
  const Programme programme = read_programme(programme_text(), "p.toml");
  const ServedBench bench(programme, rig_text(), {});
  LineLoop loop;
  ControlLine control(loop, *bench.client.plant->control);
  RigFile rig = bench.client;
  for (RigInstrument& one : rig.instruments) one.personality.deadline_s = 0.3;
  RemoteRig remote(loop, rig, programme);
  Reading reading;
  for (int i = 0; i < 2; ++i) REQUIRE(remote.next(reading));
  CHECK_FALSE(std::isnan(reading[Quantity::axial_displacement]));
  tell(control, "LINE:FAULT \"scanner\",SILENT");
  const double silent_s = loop.now_s();
  std::string told;
  bool safe = false;
  while (!safe && remote.next(reading)) {
    for (const Event& event : remote.events()) {
      told += event.detail + "\n";
      safe = safe || event.kind == EventKind::safe_state;
    }
    CHECK(std::isnan(reading[Quantity::axial_displacement]));
    CHECK_FALSE(std::isnan(reading[Quantity::back_volume]));
  }
  CHECK(safe);
  CHECK(loop.now_s() - silent_s < 4.5);
  CHECK_THAT(told, Contains("scanner gives no readings: no response within 0.3 s") &&
                       Contains("gives no readings"));
  CHECK_THAT(remote.header().cut_short, Contains("safe state"));
  tell(control, "LINE:FAULT \"scanner\",NONE");
}

TEST_CASE("a drive that does not answer leads to the safe state, though it reads nothing") {
  const Programme programme = read_programme(programme_text(), "p.toml");
  const ServedBench bench(programme, replaced(rig_text(), "watchdog_s = 1.0", "watchdog_s = 3.0"),
                          {});
  LineLoop loop;
  ControlLine control(loop, *bench.client.plant->control);
  RigFile rig = bench.client;
  for (RigInstrument& one : rig.instruments) one.personality.deadline_s = 0.3;
  RemoteRig remote(loop, rig, programme);
  Reading reading;
  for (int i = 0; i < 2; ++i) REQUIRE(remote.next(reading));
  tell(control, "LINE:FAULT \"frame\",SILENT");
  const double silent_s = loop.now_s();
  while (remote.header().cut_short.empty() && loop.now_s() < silent_s + 6 && remote.next(reading))
    CHECK_FALSE(std::isnan(reading[Quantity::axial_displacement]));
  CHECK_THAT(remote.header().cut_short,
             Contains("frame sent no valid response for 3 s: ") && Contains("no response"));
}

namespace {

/// What a rig says of a test during which this program stands still for `stall_s` after 3 readings.
struct StalledTest {
  explicit StalledTest(double stall_s) {
    const Programme programme =
        read_programme(replaced(programme_text(), "above = 1.0", "above = 0.1"), "p.toml");
    const ServedBench bench(programme,
                            replaced(rig_text(), "watchdog_s = 1.0", "watchdog_s = 30.0"), {});
    LineLoop loop;
    RemoteRig rig(loop, bench.client, programme);
    int readings = 0;
    for (Reading reading; rig.next(reading);) {
      if (++readings == 3) std::this_thread::sleep_for(std::chrono::duration<double>(stall_s));
      for (const Event& event : rig.events()) told += event.detail + "\n";
    }
    ending = rig.ending();
  }
  std::string told;
  TestEnding ending;
};

}  // namespace

TEST_CASE("RemoteRig: reports a short stall as a gap and goes on", "[wire][stall]") {
  const StalledTest test(2.1);
  CHECK_THAT(test.told, Contains("readings are missed from 3 s to 4."));
  CHECK(test.ending.kind == TestEnding::Kind::completed);
  CHECK_FALSE(test.told.find("was suspended for") < test.told.size());
}

TEST_CASE("RemoteRig: a stall above the limit leads to the safe state", "[wire][stall]") {
  const StalledTest test(3.3);
  CHECK_THAT(test.told, Contains("this program was suspended for 3."));
  CHECK(test.ending.kind == TestEnding::Kind::safe_state);
  CHECK_THAT(test.ending.reason, Contains("this program was suspended for 3."));
}

TEST_CASE("a channel may count from what it says when the test begins") {
  const Programme programme = read_programme(programme_text(), "p.toml");
  const ServedBench bench(programme, rig_text(), {.lock_step = true});
  RigFile rig = bench.client;
  for (RigChannel& channel : rig.instruments[0].channels)
    channel.from_start = channel.quantity == Quantity::cell_pressure;
  LineLoop loop;
  RemoteApparatus apparatus(loop, rig, programme);
  apparatus.connect(2);
  ControlLine control(loop, *rig.plant->control);
  Reading reading;
  reading.time_s = 0;
  apparatus.look(reading);
  CHECK(reading[Quantity::cell_pressure] == 0);
  CHECK(reading[Quantity::pore_pressure] == Approx(300e3));
  tell(control, "FAULT:ADD \"device = 'cell_pressure', kind = 'drift', drift_kPa_per_min = 60\"");
  for (int i = 0; i < 8; ++i) control.step(0.25);
  apparatus.look(reading);
  CHECK(reading[Quantity::cell_pressure] == Approx(2e3));
}

TEST_CASE("a drive that refuses its order again and again leads to the safe state") {
  const Programme slow = read_programme(programme_text(), "p.toml");
  // The client's file says that the frame is faster than it is.
  const Programme fast = read_programme(
      replaced(programme_text(), "axial_rate_mm_per_min = 1.0", "axial_rate_mm_per_min = 20.0") +
          "[rig.frame]\nfastest_mm_per_min = 100.0\n",
      "p.toml");
  const ServedBench bench(slow, rig_text(), {.lock_step = true});
  LineLoop loop;
  RemoteRig remote(loop, bench.client, fast);
  const std::vector<Reading> readings = readings_of(remote);
  CHECK(readings.size() < 20);
  CHECK_THAT(remote.header().cut_short, Contains("frame rejects commands") && Contains("-222"));
  CHECK(std::fabs(readings.back()[Quantity::axial_displacement]) < 1e-9);
}

TEST_CASE("drives hold by their watchdog when their controller is gone") {
  const Programme programme = read_programme(programme_text(), "p.toml");
  const ServedBench bench(programme, rig_text(), {});
  LineLoop loop;
  const RigInstrument& frame = *bench.client.with(RigRole::frame);
  WireInstrument one(loop, frame, {"mode", "state"});
  one.start();
  REQUIRE(loop.run_until([&one] { return one.ready(); }, loop.now_s() + 2));
  bool set = false;
  one.set({{"velocity_mm_per_min", 1}, {"mode", 1}}, [&set](const std::string& why) {
    CHECK(why == "");
    set = true;
  });
  REQUIRE(loop.run_until([&set] { return set; }, loop.now_s() + 2));
  const auto state = [&] {
    std::vector<double> said;
    one.scan([&said](const WireInstrument::Scan& scan) { said = scan.also; }, loop.now_s(), 1e9);
    loop.run_until([&said] { return !said.empty(); }, loop.now_s() + 2);
    return said;
  };
  CHECK(state() == std::vector<double>{1, 0});
  loop.run_for(1.3);  // of its watchdog 1.0
  CHECK(state() == std::vector<double>{0, 4});
}
