// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/patience.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace triax;
using namespace std::chrono_literals;

TEST_CASE("a time of waiting is told once at its start and once at its end") {
  std::vector<std::string> said;
  const db::Patience patience{
      .again = 1ms, .most = 3600s, .say = [&](const std::string& s) { said.push_back(s); }};
  db::Waiting waiting(patience);
  waiting.succeeded("t.db");
  CHECK(said.empty());
  for (int i = 0; i < 3; ++i) {
    CHECK_FALSE(waiting.failed(db::MayPass("t.db: database is locked")));
    waiting.pause();
  }
  CHECK(waiting.under_way());
  waiting.succeeded("t.db");
  CHECK_FALSE(waiting.under_way());
  REQUIRE(said.size() == 2);
  CHECK(said[0].find("t.db: database is locked; ") == 0);
  CHECK(said[1].find("t.db: ") == 0);
  waiting.failed(db::MayPass("t.db: database or disk is full"));
  CHECK(said.size() == 3);
}

TEST_CASE("patience has an end") {
  const db::Patience patience{.again = 1ms, .most = 0s};
  db::Waiting waiting(patience);
  waiting.failed(db::MayPass("locked"));
  waiting.pause();
  CHECK(waiting.failed(db::MayPass("locked")));
}

TEST_CASE("who wants to stop waits no longer") {
  bool stop = false;
  const db::Patience patience{.again = 1ms, .most = 3600s, .stop = [&] { return stop; }};
  db::Waiting waiting(patience);
  CHECK_FALSE(waiting.failed(db::MayPass("locked")));
  stop = true;
  CHECK(waiting.failed(db::MayPass("locked")));
}

TEST_CASE("patience is counted from the try that matters") {
  const db::Patience patience{.again = 20ms, .most = 3600s};
  db::Waiting waiting(patience);
  waiting.count_from_now();
  CHECK_FALSE(waiting.failed(db::MayPass("locked")));
}
