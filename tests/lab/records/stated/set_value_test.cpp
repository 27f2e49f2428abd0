// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stated/set_value.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::lab;

namespace {

RecordHeader header_with_guess() {
  RecordHeader header;
  header.stages = {{.number = 2, .role = StageRole::shear, .drainage = Drainage::closed}};
  header.guesses = {
      {.what = "stage 2",
       .otherwise = {{"stages.2.drainage", "open"}, {"stages.2.role", "consolidation"}}}};
  return header;
}

}  // namespace

TEST_CASE("set_value: an answered assumption is no longer open") {
  RecordHeader header = header_with_guess();
  set_value(header, {"stages.2.drainage", "open", "--set"});
  CHECK(header.stage(2)->drainage == Drainage::open);
  CHECK(header.stage(2)->drainage_was_said);
  REQUIRE(header.guesses.size() == 1);
  REQUIRE(header.guesses[0].otherwise.size() == 1);
  CHECK(header.guesses[0].otherwise[0].key == "stages.2.role");
  set_value(header, {"stages.2.role", "shear", "--set"});
  set_value(header, {"stages.2.drainage", "closed", "--set"});
  CHECK(header.guesses.empty());
}

TEST_CASE("set_value: the origin of a record cannot be set") {
  RecordHeader header;
  for (const char* key : {"test.origin", "test.seed"})
    CHECK_THROWS_WITH(set_value(header, {key, "1", "job.toml:4"}),
                      Catch::StartsWith("job.toml:4: ") && Catch::Contains("cannot be set"));
}

TEST_CASE("stage_of_key: only keys of stages have one") {
  CHECK(stage_of_key("stages.12.role") == 12);
  for (const char* key : {"stages.x.role", "stages.-1.role", "specimen.height_mm", "", "stages."})
    CHECK_FALSE(stage_of_key(key));
}
