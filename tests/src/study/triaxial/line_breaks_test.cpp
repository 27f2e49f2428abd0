// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/line_breaks.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "db/recording/recorder.hpp"
#include "lab/devices/noise.hpp"
#include "lab/health/sensor_finding.hpp"
#include "src/study/triaxial/stress_path.hpp"
#include "src/study/triaxial/test_result.hpp"
#include "src/study/triaxial/window.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/reduction/raw_record.hpp"

using namespace triax;
using namespace triax::study;

namespace {

constexpr std::int64_t kDead = 300, kAlive = 420, kRunaway = 500, kReadings = 600;

/// A test in which the load cell sticks from kDead on, lives again from kAlive on, and the specimen
/// runs away before kRunaway. Its verdict does not end with the sensor.
struct TestWithBreaks {
  triax::testing::TemporaryFolder folder;
  std::string path = folder.file("breaks.db");
  std::int64_t id = 0;

  explicit TestWithBreaks(bool sound = false) {
    db::Recorder recorder(path);
    const auto listener = recorder.listener();
    lab::RecordHeader header = lab::testing::raw_header();
    header.name = "breaks";
    listener.started(header);
    for (std::int64_t i = 0; i < kReadings; ++i) scan(listener, i);
    listener.happened({kDead, {}, lab::EventKind::sensor_fault, "the load cell is stuck"});
    lab::TestSummary summary;
    if (sound)
      summary.warnings = {{0, lab::sensor_name(lab::Quantity::axial_force) + " is stuck" +
                                  lab::kBelievedThough.data()}};
    id = recorder.finish(summary);
  }

  static void scan(const lab::SessionListener& listener, std::int64_t i) {
    auto reading = lab::testing::reading({3, 0.001 * double(i), 0.4, 400, 300, 0}, i);
    for (std::size_t k = 0; k < 5; ++k)
      reading.si[k] +=
          1e-4 * std::abs(reading.si[k] + 1e-3) * lab::standard_normal(1, k, std::uint64_t(i));
    if (i >= kDead && i < kAlive) reading[lab::Quantity::axial_force] = 987.5;
    lab::State state;
    state.reading = i;
    state.time_s = reading.time_s = static_cast<double>(i);
    state.stage = reading.stage;
    state.strain = {1e-5 * double(i) + (i >= kRunaway ? 0.08 : 0), 0};
    state.volumetric_strain = 0;
    state.q = i >= kRunaway ? 20e3 : 100e3 + 100 * double(i);
    state.p_eff = 200e3;
    state.pore_pressure = reading[lab::Quantity::pore_pressure];
    listener.scanned(reading, state);
  }
};

bool is_dead(std::int64_t reading) { return reading >= kDead + 1 && reading < kAlive; }

}  // namespace

TEST_CASE("load_test_result: curves have no stresses of a dead load cell") {
  const TestWithBreaks recorded;
  const auto test = load_test_result(db::Store(recorded.path), recorded.id, WithCurves::yes);
  REQUIRE(test.curves.states.size() > 100);
  CHECK(std::ranges::any_of(test.curves.states,
                            [](const lab::State& s) { return is_dead(s.reading); }));
  for (const lab::State& s : test.curves.states) {
    INFO(s.reading);
    if (is_dead(s.reading)) CHECK((std::isnan(s.q) && std::isnan(s.p_eff)));
    if (s.reading < kDead || s.reading > kAlive + 20) CHECK(std::isfinite(s.q));
    CHECK(std::isfinite(s.strain.axial));
  }
  CHECK(test.curves.breaks.unread_steps == std::vector<std::int64_t>{kRunaway});
  CHECK(test.curves.breaks.has_fault_between(kDead - 10, kAlive + 30));
  CHECK_FALSE(test.curves.breaks.has_fault_between(kAlive + 30, kReadings));
}

TEST_CASE("load_test_result: a load cell that is said to be sound is drawn") {
  const TestWithBreaks recorded(true);
  const auto test = load_test_result(db::Store(recorded.path), recorded.id, WithCurves::yes);
  CHECK(test.curves.breaks.faults.empty());
  for (const lab::State& s : test.curves.states) CHECK(std::isfinite(s.q));
}

TEST_CASE("window_json: values of a dead sensor are null, and breaks are listed") {
  const TestWithBreaks recorded;
  const db::Store store(recorded.path);
  std::vector<std::size_t> columns;
  for (const char* name : {"time_s", "axial_strain", "q_kPa", "p_eff_kPa", "axial_force_kN"})
    columns.push_back(*db::find_read_column(name));
  for (const std::size_t pixels : {std::size_t{1000}, std::size_t{5}}) {
    TestColumns test(recorded.id);
    test.read(store, columns, false);
    const auto json = nlohmann::json::parse(
        window_json(test, {.from = 0, .to = kReadings, .pixels = pixels, .columns = columns}));
    const auto& drawn = json["columns"];
    int dead = 0;
    for (std::size_t i = 0; i < drawn["reading"].size(); ++i) {
      if (!is_dead(drawn["reading"][i].get<std::int64_t>())) continue;
      ++dead;
      for (const char* name : {"q_kPa", "p_eff_kPa", "axial_force_kN"})
        CHECK(drawn[name][i].is_null());
      CHECK(drawn["axial_strain"][i].is_number());
    }
    CHECK(dead > 0);
    CHECK(json["unread_steps"] == nlohmann::json::array({kRunaway}));
    for (const std::int64_t reading : {kRunaway - 1, kRunaway})
      CHECK(std::ranges::count(drawn["reading"], nlohmann::json(reading)) == 1);
    REQUIRE(json["faults"].size() == 1);
    CHECK(json["faults"][0]["channel"] == "axial_force_kN");
    CHECK(json["faults"][0]["to"].get<std::int64_t>() >= kAlive - 1);
    CHECK(json["faults"][0]["columns"] ==
          nlohmann::json::array({"q_kPa", "p_eff_kPa", "axial_force_kN"}));
  }
}
