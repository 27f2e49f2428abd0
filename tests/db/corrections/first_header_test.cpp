// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/corrections/first_header.hpp"

#include <catch2/catch.hpp>

#include "db/connection.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

TEST_CASE("first header: comes back to the bit, with what no other table has") {
  const testing::TemporaryFolder folder;
  auto database = db::open_for_writing(folder.file("t.db"));
  lab::RecordHeader header = testing::raw_header("a");
  header.programme = "ICU";
  header.cut_short = "aborted";
  header.specimen.height_m = 0.1 + 0.2 / 7;
  header.specimen.limit_friction_angle_rad = 1.0 / 3;
  header.specimen.void_ratio.reset();
  header.stages = {{.number = 4,
                    .name = "shear \xff",
                    .role = lab::StageRole::shear,
                    .drainage = lab::Drainage::closed,
                    .strain_path_R = 0.7,
                    .drainage_was_said = true}};
  header.vouched = {lab::Quantity::cell_pressure};
  header.notes = {{"Borehole", "B3"}};
  header.guesses = {{"stage 4", "shear", "evidence", "remedy", {{"stages.4.role", "hold"}}}};
  lab::EarlierTests earlier;
  earlier.add({.name = "e", .by_law = true, .onset = 0.71, .min_work = 1.0 / 3});
  const auto id = db::insert_test(database, header, "now");
  CHECK_FALSE(db::read_first_header(database, id));
  db::insert_first_header(database, id, header, earlier);
  CHECK_FALSE(db::read_first_header(database, id)->ending);
  db::set_first_ending(database, id, {3, "why", true, {{0, 12}, {9, 21}}});
  db::set_first_ending(database, id, {1, "later", false, {}});

  const auto read = db::read_first_header(database, id);
  REQUIRE(read);
  CHECK(read->header.programme == "ICU");
  CHECK(read->header.cut_short == "aborted");
  CHECK(*read->header.specimen.height_m == *header.specimen.height_m);
  CHECK(*read->header.specimen.limit_friction_angle_rad == 1.0 / 3);
  CHECK_FALSE(read->header.specimen.void_ratio);
  REQUIRE(read->header.stages.size() == 1);
  CHECK(read->header.stages[0].role == lab::StageRole::shear);
  CHECK(read->header.stages[0].drainage_was_said);
  CHECK(*read->header.stages[0].strain_path_R == 0.7);
  CHECK(read->header.vouched == header.vouched);
  CHECK(read->header.notes.at(0).text == "B3");
  REQUIRE(read->header.guesses.size() == 1);
  CHECK(read->header.guesses[0].otherwise.at(0).value == "hold");
  REQUIRE(read->earlier.all().size() == 1);
  CHECK(read->earlier.all()[0].min_work == 1.0 / 3);
  CHECK(*read->earlier.all()[0].onset == 0.71);
  REQUIRE(read->ending);
  CHECK(read->ending->warnings == 3);
  CHECK(read->ending->cut_short == "why");
  CHECK(read->ending->back_volume_joined);
  CHECK(read->ending->stage_lines.at(1) == std::pair<std::int64_t, std::int64_t>{9, 21});

  database.exec("UPDATE first_headers SET header = '{}'");
  CHECK_THROWS_AS(db::read_first_header(database, id), lab::WorkFailed);
  db::remove_test(database, id);
  CHECK_FALSE(db::read_first_header(database, id));
}
