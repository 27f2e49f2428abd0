// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/sweep.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using Values = std::vector<std::string>;

TEST_CASE("values are lists, ranges of whole numbers, linear ranges and words, in any mixture") {
  CHECK(read_sweep_axis("seed=1:4:1").values == Values{"1", "2", "3", "4"});
  CHECK(read_sweep_axis("seed=1:3:1,20").values == Values{"1", "2", "3", "20"});
  CHECK(read_sweep_axis("seed=1..4").values == Values{"1", "2", "3", "4"});  // as it was once
  CHECK(read_sweep_axis("seed=-2..1").values == Values{"-2", "-1", "0", "1"});
  CHECK(read_sweep_axis("a.b=1.05, 1.08").values == Values{"1.05", "1.08"});
  CHECK(read_sweep_axis("a.b=x/y,z w").values == Values{"x/y", "z w"});
  CHECK(read_sweep_axis("test.seed=7").key == "seed");
  CHECK(read_sweep_axis(" specimen.void_ratio = 1").key == "specimen.void_ratio");
}

TEST_CASE("a linear range keeps its digits and its end, either way") {
  CHECK(read_sweep_axis("e=1.0:1.2:0.02").values == Values{"1.00", "1.02", "1.04", "1.06", "1.08",
                                                           "1.10", "1.12", "1.14", "1.16", "1.18",
                                                           "1.20"});
  CHECK(read_sweep_axis("e=1:2:0.4").values == Values{"1.0", "1.4", "1.8"});
  CHECK(read_sweep_axis("e=3:1:-1").values == Values{"3", "2", "1"});
  CHECK(read_sweep_axis("e=0:0.3:0.1").values.size() == 4);
  CHECK(read_sweep_axis("e=1:1:0.5").values == Values{"1.0"});
  CHECK(std::stod(read_sweep_axis("e=1e-6:3e-6:1e-6").values.back()) == Approx(3e-6));
}

TEST_CASE("a sweep text that makes no sense is refused with what would be right") {
  for (const auto& [text, words] :
       {std::pair("seed", "expected KEY=VALUES"), std::pair("=1", "expected KEY=VALUES"),
        std::pair("seed=", "a value is empty"), std::pair("seed=1,,2", "a value is empty"),
        std::pair("seed=5:1:1", "cannot reach 1 from 5"),
        std::pair("seed=1..x", "expected FROM:TO:STEP"),
        std::pair("seed=1.5..2", "expected FROM:TO:STEP"),
        std::pair("seed=1:1000000:1", "more than 100000"), std::pair("e=1:2", "FROM:TO:STEP"),
        std::pair("e=1:2:3:4", "FROM:TO:STEP"), std::pair("e=1:2:0", "cannot reach"),
        std::pair("e=1:2:-1", "cannot reach"), std::pair("e=a:2:1", "is not a range"),
        std::pair("e=0:1:1e-9", "more than 100000"), std::pair("e=nan:2:1", "is not a range")}) {
    INFO(text);
    CHECK_THROWS_AS(read_sweep_axis(text), BadInput);
    CHECK_THROWS_WITH(read_sweep_axis(text), Catch::Contains("--sweep") && Catch::Contains(words));
  }
  CHECK_THROWS_AS(Sweep({}), BadInput);
  CHECK_THROWS_WITH(Sweep({read_sweep_axis("seed=1"), read_sweep_axis("test.seed=2")}),
                    Catch::Contains("given twice"));
  CHECK_THROWS_WITH(Sweep({read_sweep_axis("a=1..1000"), read_sweep_axis("b=1..1000")}),
                    Catch::Contains("more than 100000 tests"));
}

TEST_CASE("the product has every combination once, the last key running fastest") {
  const Sweep sweep(
      {read_sweep_axis("specimen.void_ratio=1.05,1.1"), read_sweep_axis("seed=1:3:1")});
  REQUIRE(sweep.size() == 6);
  Values labels;
  for (std::int64_t place = 1; place <= 6; ++place) labels.push_back(sweep.label(place));
  CHECK(labels == Values{"void_ratio 1.05, seed 1", "void_ratio 1.05, seed 2",
                         "void_ratio 1.05, seed 3", "void_ratio 1.1, seed 1",
                         "void_ratio 1.1, seed 2", "void_ratio 1.1, seed 3"});
  CHECK(sweep.edits(4)[1].key == "test.seed");
  CHECK(sweep.values(4)[1] == std::pair<std::string, std::string>("seed", "1"));
  const Sweep alike({read_sweep_axis("stages.1.x=1"), read_sweep_axis("stages.2.x=2")});
  CHECK(alike.label(1) == "stages.1.x 1, stages.2.x 2");
}

TEST_CASE("each value stands in the programme that is read, at its place and in its unit") {
  const Sweep sweep({read_sweep_axis("specimen.void_ratio=1.0,1.1"), read_sweep_axis("seed=8,9"),
                     read_sweep_axis("stages.1.axial_rate_mm_per_min=0.5"),
                     read_sweep_axis("stages.1.end.1.above=2"),
                     read_sweep_axis("rig.transducers.axial_force.noise_N=0.25"),
                     read_sweep_axis("specimen.material=inl2/S28-general")});
  const Programme programme = read_programme(test::programme_text(), "p.toml", sweep.edits(4));
  CHECK(programme.void_ratio == 1.1);
  CHECK(programme.seed == 9);
  CHECK(programme.stages[0].axial_rate_m_per_s == Approx(0.5e-3 / 60));
  CHECK(programme.stages[0].end[0].above == Approx(0.02));
  CHECK(programme.transducers[1].noise_rms == Approx(0.25e-3));
  CHECK(programme.material.name == "inl2/S28-general");
}
