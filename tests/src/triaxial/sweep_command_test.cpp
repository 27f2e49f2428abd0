// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sweep_command.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/src/study/sweep/sweep_programme.hpp"

using namespace triax;
using namespace triax::src;
using Catch::Contains;

TEST_CASE("a sweep that no test can be made of is refused before anything is stored") {
  testing::TemporaryFolder folder;
  const std::string programme = src::test::short_programme_in(folder.file("p.toml"));
  const std::string db = folder.file("t.db");
  for (const auto& [text, words] :
       {std::pair("specimen.viod_ratio=1.0,1.1", "did you mean 'void_ratio'"),
        std::pair("stages.9.axial_rate_mm_per_min=1", "not an item of stages"),
        std::pair("specimen.void_ratio=98,99", "[void_ratio 98]"),
        std::pair("seed=5:1:1", "cannot reach 1 from 5")}) {
    INFO(text);
    CHECK_THROWS_AS(run_sweep_command({programme, {}, {text}, db, 0, 1, false}), lab::BadInput);
    CHECK_THROWS_WITH(run_sweep_command({programme, {}, {text}, db, 0, 1, false}),
                      Contains("--sweep") && Contains(words));
  }
  CHECK_THROWS_WITH(run_sweep_command({programme, {}, {"seed=1"}, programme, 0, 1, false}),
                    Contains("--db"));
  CHECK_THROWS_AS(run_sweep_command({folder.file("no.toml"), {}, {"seed=1"}, db, 0, 1, false}),
                  lab::BadInput);
  CHECK_FALSE(std::filesystem::exists(db));
}
