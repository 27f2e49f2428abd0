// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/window.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <future>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "db/recording/recorder.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace triax::study;

namespace {

constexpr std::int64_t kScans = 5000;

/// q is noise about a wave; p′ falls, and is unknown at times; a drop of one reading.
void record(db::Recorder& recorder, std::int64_t scans) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 100);
  const auto listener = recorder.listener();
  lab::RecordHeader header;
  header.name = "wave";
  listener.started(header);
  for (std::int64_t i = 0; i < scans; ++i) {
    lab::Reading reading;
    reading.number = i;
    reading.time_s = 0.5 * static_cast<double>(i);
    lab::State state;
    state.reading = i;
    state.time_s = reading.time_s;
    state.q = 60e3 * std::sin(static_cast<double>(i) / 700) + noise(random);
    state.p_eff = i % 9 == 4 ? lab::kMissing : 300e3 - 20.0 * static_cast<double>(i);
    if (i == 3210) state.q = -90e3;
    listener.scanned(reading, state);
    if (i % 10 == 0)
      listener.second_order_work({.reading = i, .time_s = reading.time_s, .work = {0, 0, 0, 0.5}});
  }
}

std::size_t place(std::string_view name) { return *db::find_read_column(name); }

std::vector<std::size_t> columns() { return {place("time_s"), place("q_kPa"), place("p_eff_kPa")}; }

struct Recorded {
  triax::testing::TemporaryFolder folder;
  std::string path = folder.file("window.db");
  std::int64_t id = 0;
  explicit Recorded(std::int64_t scans = kScans) {
    db::Recorder recorder(path);
    record(recorder, scans);
    id = recorder.finish({});
  }
};

}  // namespace

TEST_CASE("a window holds the least and the largest of every bucket, and real readings only") {
  const Recorded recorded;
  const db::Store store(recorded.path);
  TestColumns test(recorded.id);
  test.read(store, columns(), false);
  REQUIRE(std::ssize(test.readings()) == kScans);
  const auto& q = test.column(place("q_kPa"));
  for (const auto& [from, to] : {std::pair{std::int64_t{0}, kScans}, {1000, 4000}, {3000, 3999}}) {
    const WindowAsked asked{.from = from, .to = to, .pixels = 50, .columns = columns()};
    const Window chosen = window(test, asked);
    CHECK_FALSE(chosen.exact);
    CHECK(chosen.rows.size() <= 2 * 2 * 50 + 2);
    CHECK(std::ranges::is_sorted(chosen.rows));
    CHECK(chosen.rows.front() == static_cast<std::size_t>(from));
    CHECK(chosen.rows.back() == static_cast<std::size_t>(std::min(to, kScans - 1)));
    const auto count = static_cast<std::size_t>(chosen.count);
    for (std::size_t bucket = 0; bucket < 50; ++bucket) {
      const auto first = static_cast<std::size_t>(from) + count * bucket / 50;
      const auto behind = static_cast<std::size_t>(from) + count * (bucket + 1) / 50;
      const auto [least, largest] =
          std::minmax_element(q.begin() + static_cast<std::ptrdiff_t>(first),
                              q.begin() + static_cast<std::ptrdiff_t>(behind));
      CHECK(std::ranges::count(chosen.rows, static_cast<std::size_t>(least - q.begin())) == 1);
      CHECK(std::ranges::count(chosen.rows, static_cast<std::size_t>(largest - q.begin())) == 1);
    }
  }
}

TEST_CASE("all readings are given where they are few, and none where there is none") {
  const Recorded recorded;
  const db::Store store(recorded.path);
  TestColumns test(recorded.id);
  test.read(store, columns(), false);
  const Window few = window(test, {.from = 100, .to = 299, .pixels = 50, .columns = columns()});
  CHECK(few.exact);
  CHECK(few.rows.size() == 200);
  CHECK(window(test, {.from = kScans, .to = kScans + 10, .pixels = 5, .columns = columns()})
            .rows.empty());
  CHECK(window(test, {.from = 20, .to = 10, .pixels = 5, .columns = columns()}).rows.size() == 1);
}

TEST_CASE("what is missing is kept out of the extremes and null in the document") {
  const Recorded recorded;
  const db::Store store(recorded.path);
  TestColumns test(recorded.id);
  test.read(store, columns(), false);
  test.read_work(store, false);
  const auto json = nlohmann::json::parse(
      window_json(test, {.from = 0, .to = 9, .pixels = 100, .columns = columns(), .work = true}));
  CHECK(json["exact"] == true);
  CHECK(json["count"] == 10);
  CHECK(json["last"] == kScans - 1);
  CHECK(json["columns"]["reading"] == nlohmann::json({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  CHECK(json["columns"]["p_eff_kPa"][4].is_null());
  CHECK(json["columns"]["p_eff_kPa"][5] == 299.9);
  CHECK(json["columns"]["time_s"][3] == 1.5);
  CHECK(json["work"]["reading"] == nlohmann::json::array({0}));
  CHECK(json["work"]["normalised"] == nlohmann::json::array({0.5}));
  std::vector<std::size_t> kept;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  keep_extremes(std::vector{nan, nan, 3.0, nan, 2.0, 3.0}, 0, 6, 1, kept);
  CHECK(kept == std::vector<std::size_t>{4, 2});
  kept.clear();
  keep_extremes(std::vector{nan, nan}, 0, 2, 1, kept);
  CHECK(kept.empty());
}

TEST_CASE("TestColumns: a leap of the strain is found if only q is asked for") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("leap.db");
  db::Recorder recorder(path);
  const auto listener = recorder.listener();
  listener.started({});
  for (std::int64_t i = 0; i < 100; ++i) {
    lab::Reading reading;
    lab::State state;
    reading.number = state.reading = i;
    reading.time_s = state.time_s = static_cast<double>(i);
    state.strain.axial = 1e-4 * static_cast<double>(i) + (i < 60 ? 0 : 0.05);
    state.q = 50e3;
    listener.scanned(reading, state);
  }
  TestColumns test(recorder.finish({}));
  const db::Store store(path);
  test.read(store, std::vector{place("q_kPa"), place("p_eff_kPa")}, false);
  CHECK(test.unread_steps() == std::vector<std::int64_t>{60});
}

TEST_CASE("a test that runs grows by what is new, and columns asked for later have its length") {
  const triax::testing::TemporaryFolder folder;
  const std::string path = folder.file("grows.db");
  db::Recorder recorder(path);
  std::promise<std::int64_t> entered;
  recorder.when_entered([&entered](std::int64_t id) { entered.set_value(id); });
  record(recorder, 20000);  // more than a batch: a part is there before the end
  REQUIRE(entered.get_future().get() == 1);
  TestColumns test(1);
  std::size_t seen = 0;
  {
    const db::Store store(path);
    test.read(store, std::vector{place("q_kPa")}, true);
    seen = test.readings().size();
    CHECK(seen > 0);
  }
  CHECK(recorder.finish({}) == 1);
  const db::Store store(path);
  test.read(store, columns(), true);
  CHECK(test.readings().size() == 20000);
  CHECK(test.column(place("p_eff_kPa")).size() == 20000);
  TestColumns anew(1);
  anew.read(store, columns(), false);
  CHECK(anew.column(place("q_kPa")) == test.column(place("q_kPa")));
  const auto without = test.bytes_with(columns(), false, 20000);
  CHECK(without >= 20000 * 8 * 4);
  CHECK(test.bytes_with(columns(), true, 20000) ==
        without + 20000 * sizeof(lab::SecondOrderWorkPoint));
}
