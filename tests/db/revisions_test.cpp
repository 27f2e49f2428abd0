// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/revisions.hpp"

#include <catch2/catch.hpp>

#include "db/catalogue.hpp"
#include "db/connection.hpp"
#include "db/query.hpp"
#include "db/test_writer.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;

TEST_CASE("revisions: come back in order, with list, version and named query") {
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("t.db");
  auto database = db::open_for_writing(path);
  const auto id = db::insert_test(database, testing::raw_header("a"), "now");
  const auto other = db::insert_test(database, testing::raw_header("b"), "now");
  CHECK(db::read_revisions(database, id).empty());
  db::insert_revision(database, id,
                      {2,
                       "2026-01-01T00:00:00Z",
                       {{"specimen.height_mm", "140", "150"}, {"labels.client", "", "A"}},
                       lab::CollapseKind::flow,
                       0.75});
  db::insert_revision(database, id,
                      {3, "2026-01-02T00:00:00Z", {{"labels.client", "A", ""}}, {}, {}});

  const auto all = db::read_revisions(database, id);
  REQUIRE(all.size() == 2);
  CHECK(all[0].number == 2);
  CHECK(all[0].revised_at == "2026-01-01T00:00:00Z");
  CHECK(all[0].former_kind == lab::CollapseKind::flow);
  CHECK(all[0].former_eta == 0.75);
  REQUIRE(all[0].values.size() == 2);
  CHECK(all[0].values[0].after == "150");
  CHECK(all[0].values[1].before.empty());
  CHECK_FALSE(all[1].former_kind);
  CHECK_FALSE(all[1].former_eta);
  CHECK(db::read_revisions(database, other).empty());

  CHECK(db::Store(path).load(id).revisions.size() == 2);
  CHECK(db::Store(path).version(id).revision == 3);
  CHECK(db::Store(path).version(other).revision == 1);
  CHECK(db::list_tests(path).at(0).revision == 3);
  int rows = 0;
  db::query(
      path, "revisions", [](const auto&) {}, [&](const auto&) { ++rows; });
  CHECK(rows == 3);
  db::remove_test(database, id);
  CHECK(database.execAndGet("SELECT count(*) FROM revised_values").getInt() == 0);
}
