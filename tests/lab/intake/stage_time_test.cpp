// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/stage_time.hpp"

#include <string>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "lab/intake/proposal.hpp"

using namespace triax::lab;

namespace {

/// Two stages of 15 rows. The time of the second one begins at `begin`.
bool has_stage_time(const char* first, const char* second, int begin) {
  std::string text = "Stage,Time (s),Axial strain (%),Deviator stress (kPa)\n";
  for (int i = 0; i < 30; ++i)
    text += fmt::format("{},{},{:.2f},{:.1f}\n", i < 15 ? first : second,
                        i < 15 ? 10 * i : begin + 10 * (i - 15), 0.1 * i, 100.0 * i / (i + 5));
  const auto source = open_memory("m.csv", text);
  const Proposal proposal = propose(*source, 0);
  CHECK(proposal.test_begins.size() == 1);
  return proposal.has("stage_time") && !proposal.has("time");
}

}  // namespace

TEST_CASE("find_stage_time: a time that falls back with each stage") {
  CHECK(has_stage_time("1", "2", 0));
  CHECK(has_stage_time("Consolidation", "Shear", 0));
}

TEST_CASE("find_stage_time: a time that goes on is that of the test") {
  CHECK_FALSE(has_stage_time("1", "2", 150));
  CHECK_FALSE(has_stage_time("1", "1", 0));
}

TEST_CASE("find_stage_time: the time of the test beside it keeps its name") {
  std::string text = "Stage,Zeit ab Phasenanfang (min),Zeit (min),Axial strain (%),q (kPa)\n";
  for (int i = 0; i < 30; ++i)
    text +=
        fmt::format("{},{},{},{:.2f},{:.1f}\n", i / 15, i % 15, i, 0.1 * i, 100.0 * i / (i + 5));
  const auto source = open_memory("m.csv", text);
  const Proposal proposal = propose(*source, 0);
  const ColumnMeaning* time = proposal.meaning.of("time");
  const ColumnMeaning* stage_time = proposal.meaning.of("stage_time");
  REQUIRE(time);
  REQUIRE(stage_time);
  CHECK(time - proposal.meaning.columns.data() == 2);
  CHECK(time->reading.factor == 60);
  CHECK(stage_time->reading.factor == 60);
}
