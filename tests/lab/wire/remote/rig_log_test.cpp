// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/rig_log.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "lab/base/bad_input.hpp"
#include "lab/rig/recorded.hpp"
#include "tests/lab/wire/served_bench.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;

namespace {

struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("triax-rig-log-" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
};

std::string content(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Programme programme() { return read_programme(programme_text(), "p.toml"); }

/// A pad that does not say who it is, by TCP; a channel that no test has, and one that hangs free.
std::string pad_text() {
  return "[rig]\nname = \"pad\"\n[plant]\nprogramme = \"p.toml\"\ncontrol = "
         "\"tcp://127.0.0.1:0\"\n[[instruments]]\nname = \"pad\"\nlink = \"tcp://127.0.0.1:0\"\n"
         "personality = \"pad\"\n"
         "[[instruments.channels]]\nquantity = \"cell_pressure\"\nat = 1\nunit = \"kPa\"\n"
         "calibration = {gain = 0.5, offset = 100.0}\n"
         "[[instruments.channels]]\nquantity = \"room\"\nat = 2\nunit = \"degC\"\n";
}

}  // namespace

TEST_CASE("what instruments say is a record that can be replayed, marked as what it is") {
  const Folder here;
  const ServedBench bench(programme(), rig_text(), {});
  const RigLogged logged =
      log_rig(bench.client, here / "a.csv", {.interval_s = 0.05, .readings = 5});
  CHECK(logged.readings == 5);
  CHECK(logged.missing_cells == 0);
  CHECK(logged.simulated);
  const std::string text = content(here / "a.csv");
  CHECK_THAT(text, Contains("## instrument scanner: triax,34970A,simulated,1") &&
                       Contains("axial_force_kN") && Contains("2026-03-17"));
  const auto record = open_record(here / "a.csv", {});
  CHECK(record->header().origin == Origin::simulated);
  Reading reading;
  int readings = 0;
  for (; record->next(reading); ++readings) {
    CHECK(reading[Quantity::cell_pressure] == Approx(400e3));
    CHECK(reading.time_s == Approx(0.05 * readings).margin(0.04));
  }
  CHECK(readings == 5);
}

TEST_CASE("an instrument that does not say who it is does not make a served rig a real one") {
  const Folder here;
  const ServedBench bench(programme(), pad_text(), {});
  const RigLogged logged =
      log_rig(bench.client, here / "pad.csv", {.interval_s = 0.05, .readings = 2});
  CHECK(logged.simulated);
  CHECK(logged.missing_cells == 2);  // of the free channel
  CHECK_THAT(content(here / "pad.csv"), Contains("origin = \"simulated\"") &&
                                            Contains("cell_pressure_kPa,room_degC\n") &&
                                            Contains(",1,400,\n"));
}

TEST_CASE("a gap is a row of empty cells, told with its cause and its end") {
  const Folder here;
  const ServedBench bench(programme(), rig_text(), {});
  RigFile rig = bench.client;
  for (RigInstrument& one : rig.instruments) one.personality.deadline_s = 0.2;
  LineLoop loop;
  ControlLine control(loop, *rig.plant->control);
  std::string told;
  const RigLogged logged =
      log_rig(rig, here / "gap.csv",
              {.interval_s = 0.1,
               .readings = 25,
               .say = [&told](const std::string& sentence) { told += sentence + "\n"; },
               .progressed =
                   [&](std::int64_t readings, double) {
                     if (readings == 3) tell(control, "LINE:FAULT \"cell\",SILENT");
                     if (readings == 8) tell(control, "LINE:FAULT \"cell\",NONE");
                   }});
  CHECK(logged.missing_cells >= 5);
  CHECK(logged.missing_cells < 22);
  CHECK_THAT(told, Contains("cell gives no readings: no response within 0.2 s") &&
                       Contains("cell responds again after"));
}

TEST_CASE("log_rig: reports the readings that a stall missed", "[wire][stall]") {
  const Folder here;
  const ServedBench bench(programme(), rig_text(), {});
  std::string told;
  const RigLogged logged =
      log_rig(bench.client, here / "stall.csv",
              {.interval_s = 0.1,
               .readings = 6,
               .say = [&told](const std::string& sentence) { told += sentence + "\n"; },
               .progressed =
                   [](std::int64_t readings, double) {
                     if (readings == 3) std::this_thread::sleep_for(std::chrono::milliseconds(450));
                   }});
  CHECK(logged.readings == 6);
  CHECK(logged.silent.empty());
  CHECK_FALSE(logged.stopped);
  CHECK_THAT(told, Contains("readings are missed from 0.3 s to 0.7"));
}

TEST_CASE("log_rig: names the instruments that are silent at its end", "[wire]") {
  const Folder here;
  const ServedBench bench(programme(), rig_text(), {});
  RigFile rig = bench.client;
  for (RigInstrument& one : rig.instruments) one.personality.deadline_s = 0.2;
  LineLoop loop;
  ControlLine control(loop, *rig.plant->control);
  bool stop = false;
  const RigLogged logged = log_rig(rig, here / "silent.csv",
                                   {.interval_s = 0.1,
                                    .readings = 100,
                                    .stop = [&stop] { return stop; },
                                    .progressed =
                                        [&](std::int64_t readings, double) {
                                          if (readings == 2)
                                            tell(control, "LINE:FAULT \"cell\",SILENT");
                                          stop = readings == 4;
                                        }});
  CHECK(logged.stopped);
  REQUIRE(logged.silent.size() == 1);
  CHECK_THAT(logged.silent[0], Contains("cell: ") && Contains("no response"));
  tell(control, "LINE:FAULT \"cell\",NONE");
}

TEST_CASE("a log writes over nothing, and begins nothing where nobody answers") {
  const Folder here;
  const ServedBench bench(programme(), rig_text(), {});
  std::ofstream(here / "mine.csv") << "mine";
  CHECK_THROWS_AS(log_rig(bench.client, here / "mine.csv", {.readings = 1}), BadInput);
  CHECK(content(here / "mine.csv") == "mine");
}
