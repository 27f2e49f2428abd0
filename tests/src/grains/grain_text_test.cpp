// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/grain_text.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "src/output/table.hpp"
#include "tests/src/contains.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;
using test::contains;

TEST_CASE("the text says what is simulated, of which grains, with which contacts") {
  const std::string text = grain_text(test::stored(test::sample_run()));
  CHECK(text.find("Grains, sample (simulated)\n") == 0);
  CHECK(contains(text, "4, diameters 2.00 to 8.00 mm, median 4.00 mm by count"));
  CHECK(contains(text, "seed 7, compacted to 100.0 kPa with a friction of 14.00°"));
  CHECK(contains(text, "kn/Ds 356 MPa, read as kn = 2 E r1 r2/(r1 + r2) (in series)"));
  CHECK(contains(text, "4 grains float, 0 outside"));
  CHECK(contains(text, "local damping 0.2, time step 2e-06 s"));
}

TEST_CASE("the text says what came of every stage") {
  const std::string text = grain_text(test::stored(test::sample_run()));
  CHECK(contains(text, "COLLAPSED at ε₁ = 0.40 %"));
  CHECK(contains(text, "35 of 36 probes at rest"));
  CHECK(contains(text, "Eq. (7): 220° to 230°"));
  CHECK(contains(text, "NOT AT REST 140° to 140°"));
  CHECK(contains(text, "strains by 1.00e-08, 0.10 % of the smallest probe's"));
  CHECK(contains(text, "never reached"));
}

TEST_CASE("no line is longer than a terminal is wide") {
  std::istringstream lines(grain_text(test::stored(test::sample_run())));
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(display_width(line) <= 100);
  }
}

TEST_CASE("the other reading of the stiffness and a specimen from a file are told as such") {
  lab::GrainReport report = test::sample_run();
  report.specimen->law.reading = sim::StiffnessReading::literal;
  report.specimen->state_file = "dense.grains";
  const std::string text = grain_text(test::stored(report));
  CHECK(contains(text, "kn = 4 E r1 r2/(r1 + r2) (literal)"));
  CHECK(contains(text, "loaded from dense.grains"));
  CHECK_FALSE(contains(text, "compacted"));
}

TEST_CASE("before anything happened there is a head and no table") {
  const std::string text = grain_text(test::stored({"sample", "sample.toml", {}, {}}));
  CHECK(text ==
        "Grains, sample (simulated)\n==========================\n  source      sample.toml\n");
}
