// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sweep/sweep_run.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <set>

#include "db/store.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/src/study/sweep/sweep_programme.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {

const auto never = [] { return false; };
const auto silent = [](const SweepCounts&) {};

std::vector<SweepMember> run(const lab::Sweep& sweep, const std::string& db, int jobs) {
  return run_sweep({.file = "p.toml",
                    .text = src::test::short_programme(),
                    .sweep = sweep,
                    .name = "a sweep",
                    .db = db,
                    .jobs = jobs},
                   never, silent);
}

}  // namespace

TEST_CASE("results and ids are the same with one thread and with three", "[threads]") {
  testing::TemporaryFolder folder;
  const auto sweep = src::test::sweep_of({"specimen.void_ratio=1.05,1.08,1.1", "seed=1:4:1"});
  const auto one = run(sweep, folder.file("one.db"), 1);
  const auto three = run(sweep, folder.file("three.db"), 3);
  REQUIRE(one.size() == 12);
  REQUIRE(three.size() == 12);
  const db::Store a(folder.file("one.db")), b(folder.file("three.db"));
  for (std::size_t i = 0; i < 12; ++i) {
    INFO(i << ": " << one[i].failure << three[i].failure);
    REQUIRE(one[i].id);
    CHECK(one[i].place == static_cast<std::int64_t>(i) + 1);
    CHECK(one[i].id == three[i].id);
    CHECK(one[i].eta == three[i].eta);
    CHECK(one[i].true_eta == three[i].true_eta);
    const auto stored = a.load(*one[i].id), other = b.load(*three[i].id);
    CHECK(stored.header.name == "small [" + sweep.label(one[i].place) + "]");
    CHECK(stored.header.name == other.header.name);
    CHECK(stored.header.seed == i % 4 + 1);
    CHECK(stored.sweep->values == sweep.values(one[i].place));
    CHECK(stored.summary.readings == other.summary.readings);
  }
  CHECK(a.load(1).header.specimen.void_ratio == 1.05);
  CHECK(a.load(12).header.specimen.void_ratio == 1.1);
}

TEST_CASE("a test whose values make no sense says so, the others go on", "[threads]") {
  testing::TemporaryFolder folder;
  const auto sweep = src::test::sweep_of({"specimen.void_ratio=1.08,99,1.1"});
  const auto members = run(sweep, folder.file("t.db"), 2);
  REQUIRE(members.size() == 3);
  CHECK(members[0].id == 1);
  CHECK_FALSE(members[1].id);
  CHECK_THAT(members[1].failure, Catch::Contains("void_ratio") && Catch::Contains("99"));
  CHECK(members[2].id == 2);
}

TEST_CASE("a sweep that is stopped keeps the finished tests and no others", "[threads]") {
  testing::TemporaryFolder folder;
  const auto sweep = src::test::sweep_of({"seed=1:500:1"});
  std::atomic<std::int64_t> asked = 0;
  // A test of about 90 readings asks after each.
  const auto members = run_sweep(
      {.file = "p.toml",
       .text = src::test::short_programme(),
       .sweep = sweep,
       .name = "a sweep",
       .db = folder.file("t.db"),
       .jobs = 2},
      [&] { return ++asked > 2000; }, silent);
  std::set<std::int64_t> ids;
  for (const SweepMember& m : members)
    if (m.id) ids.insert(*m.id);
  CHECK(ids.size() > 2);
  CHECK(ids.size() < 500);
  const db::Store store(folder.file("t.db"));
  CHECK(store.find({}).size() == ids.size());
  for (const auto id : store.find({})) {
    CHECK(ids.count(id) == 1);
    CHECK(store.load(id).status == db::TestStatus::complete);
  }
}
