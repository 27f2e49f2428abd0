// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/correction/correct_test.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "db/connection.hpp"
#include "db/query.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/rig/otherwise.hpp"
#include "lab/rig/recorded.hpp"
#include "src/study/triaxial/test_run.hpp"
#include "src/triaxial/json_report.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using Catch::Contains;
using study::correct_test;

namespace {

std::int64_t replay(std::string db, const std::string& record, lab::RecordOptions options = {}) {
  const auto rig = lab::open_record(record, options);
  return study::run_test(*rig,
                         {.otherwise =
                              [&] {
                                return lab::judge_otherwise(
                                    rig->header(), {}, [&](const auto& said) {
                                      auto other = options;
                                      other.sets.emplace_back(said.key, said.value);
                                      return lab::open_record(record, other);
                                    });
                              }},
                         db);
}

/// Every row of every table and view that a correction may write, as text, but for revisions.
std::string everything(const std::string& db, std::int64_t id) {
  std::string text;
  for (const char* table : {"tests", "specimens", "stages", "stage_references", "readings",
                            "states", "second_order_work", "forecasts", "consolidations",
                            "verdicts", "criteria", "truths", "checks", "cyclic_loadings",
                            "outlooks", "guards", "instants", "losses_of_control", "run_aways"}) {
    text += std::string(table) + '\n';
    db::query(
        db, "SELECT * FROM " + std::string(table) + " WHERE test_id = " + std::to_string(id),
        [](const auto&) {},
        [&](const std::vector<db::Value>& row) {
          for (const db::Value& value : row)
            std::visit(
                [&](const auto& cell) {
                  using Cell = std::decay_t<decltype(cell)>;
                  if constexpr (std::is_same_v<Cell, double>)
                    text += nlohmann::json(cell).dump() + '|';
                  else if constexpr (std::is_same_v<Cell, std::string>)
                    text += cell + '|';
                  else if constexpr (std::is_same_v<Cell, std::int64_t>)
                    text += std::to_string(cell) + '|';
                },
                value);
          text += '\n';
        });
  }
  auto document = src::test_document(db::Store(db).load(id));
  document.erase("revisions");
  return text + document.dump();
}

std::string first_difference(const std::string& a, const std::string& b) {
  if (a == b) return {};
  const auto at = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
  const auto from = at > 200 ? at - 200 : 0;
  return "..." + a.substr(from, 400) + "\n--- against\n..." + b.substr(from, 400);
}

}  // namespace

TEST_CASE("correct_test: values that are set back give the results of then, to the bit") {
  const testing::TemporaryFolder folder;
  const std::string db = folder.file("t.db");
  for (const char* record : {"samples/records/icu_6.csv", "samples/records/csd_58.csv"}) {
    const auto id = replay(db, record);
    const std::string before = everything(db, id);
    const auto stored = db::Store(db).load(id);
    const double height_mm = *stored.header.specimen.height_m * 1e3;

    auto corrected = correct_test(db, id,
                                  {{"specimen.height_cm", "15"},
                                   {"specimen.limit_friction_angle_deg", "31"},
                                   {"labels.client", "A"}});
    CHECK(corrected.revision == 2);
    REQUIRE(corrected.values.size() == 3);
    CHECK(corrected.values[0].key == "specimen.height_mm");
    CHECK(corrected.values[0].after == "150");
    const auto now = db::Store(db).load(id);
    CHECK(*now.header.specimen.height_m == Approx(0.15));
    CHECK(now.header.notes.front().text == "A");
    CHECK(now.summary.collapse.limit_source == lab::kGivenLimit);
    CHECK(everything(db, id) != before);

    corrected = correct_test(db, id,
                             {{"specimen.height_mm", nlohmann::json(height_mm).dump()},
                              {"specimen.limit_friction_angle_deg", corrected.values[1].before},
                              {"labels.client", ""}});
    CHECK(corrected.revision == 3);
    CHECK(first_difference(everything(db, id), before).empty());
    INFO(first_difference(everything(db, id), before));
    CHECK(everything(db, id) == before);
    CHECK(db::Store(db).load(id).revisions.size() == 2);
  }
}

TEST_CASE("correct_test: the same as a replay with --set") {
  const testing::TemporaryFolder folder;
  const std::string db = folder.file("t.db");
  const std::string record = "samples/records/icu_6.csv";
  const auto stored = replay(db, record);
  const auto replayed =
      replay(folder.file("replayed.db"), record,
             {.sets = {{"specimen.limit_friction_angle_deg", "40"}, {"test.programme", "CIU"}}});
  correct_test(db, stored,
               {{"specimen.limit_friction_angle_deg", "40"}, {"test.programme", "CIU"}});
  const auto a = db::Store(db).load(stored),
             b = db::Store(folder.file("replayed.db")).load(replayed);
  CHECK(a.header.programme == "CIU");
  CHECK(a.summary.collapse.kind == b.summary.collapse.kind);
  CHECK(*a.summary.collapse.limit_stress_ratio == *b.summary.collapse.limit_stress_ratio);
  CHECK(a.summary.collapse.onset->reading == b.summary.collapse.onset->reading);
  CHECK(a.events.size() == b.events.size());
}

TEST_CASE("correct_test: assumptions of a record are answered, and come back") {
  const testing::TemporaryFolder folder;
  const std::string db = folder.file("t.db"), record = folder.file("r.csv");
  std::ofstream(record) << "stage,axial_strain_pct,deviator_stress_kPa,mean_effective_stress_kPa,"
                           "volumetric_strain_pct\n1,0,0,100,0\n1,0,0,101,0.5\n1,0,0,110,0.9\n"
                           "2,0,5,110,0.9\n2,1,40,112,0.9\n2,2,60,113,0.9\n";
  const auto id = replay(db, record);
  const std::string before = everything(db, id);
  CHECK(db::Store(db).load(id).header.guesses.size() == 2);
  const auto inferred = db::Store(db).load(id).header.stage(2)->drainage;
  const auto other = inferred == lab::Drainage::open ? "closed" : "open";
  CHECK(correct_test(db, id, {{"stages.2.drainage", other}}).revision == 2);
  CHECK(to_string(db::Store(db).load(id).header.stage(2)->drainage) == other);
  CHECK(everything(db, id) != before);
  CHECK(correct_test(db, id, {{"stages.2.drainage", ""}}).revision == 3);
  CHECK(everything(db, id) == before);
}

TEST_CASE("correct_test: stores nothing where nothing changes or a value is wrong") {
  const testing::TemporaryFolder folder;
  const std::string db = folder.file("t.db");
  const auto id = replay(db, "samples/records/icu_6.csv");
  const std::string before = everything(db, id);
  CHECK(correct_test(db, id, {{"test.programme", db::Store(db).load(id).header.programme}})
            .revision == 0);
  CHECK(correct_test(db, id, {{"labels.client", ""}}).revision == 0);
  const auto refuses = [&](const std::string& key, const std::string& value) {
    try {
      correct_test(db, id, {{"labels.client", "A"}, {key, value}});
    } catch (const lab::BadInput& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(refuses("specimen.hight_mm", "3"), Contains("did you mean 'specimen.height_mm'"));
  CHECK_THAT(refuses("specimen.hight_mm", ""), Contains("did you mean 'specimen.height_mm'"));
  CHECK_THAT(refuses("specimen.height_mm", "-3"), Contains("out of range"));
  CHECK_THAT(refuses("stages.99.role", "shear"), Contains("has no stage 99"));
  CHECK_THAT(refuses("stages.1.roel", ""), Contains("unknown key"));
  for (const char* key : {"test.origin", "test.seed"})
    for (const char* value : {"1", ""}) CHECK_THAT(refuses(key, value), Contains("cannot be set"));
  CHECK_FALSE(refuses("test.name", "").empty());
  CHECK_FALSE(refuses("", "").empty());
  CHECK(db::Store(db).load(id).revisions.empty());
  CHECK(everything(db, id) == before);
  CHECK_THROWS_AS(correct_test(db, 99, {{"labels.client", "A"}}), lab::BadInput);
}

TEST_CASE("correct_test: a test of an older triax is corrected if its readings give its result") {
  const testing::TemporaryFolder folder;
  const std::string db = folder.file("t.db");
  const auto id = replay(db, "samples/records/icu_6.csv");
  db::open_for_writing(db).exec("DELETE FROM first_headers");
  CHECK(correct_test(db, id, {{"labels.client", "A"}}).revision == 2);
  db::open_for_writing(db).exec("UPDATE verdicts SET kind = 'limited'");
  CHECK_THROWS_WITH(correct_test(db, id, {{"labels.client", "B"}}), Contains("older triax"));
}
