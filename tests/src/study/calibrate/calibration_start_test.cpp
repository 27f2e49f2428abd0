// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/calibration_start.hpp"

#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>

#include "lab/base/bad_input.hpp"
#include "src/study/calibrate/search_space.hpp"

using namespace triax;
using namespace triax::study;
using Catch::Contains;

namespace {

struct TextFile {
  std::string path;
  TextFile(std::string name, const std::string& text) : path(std::move(name)) {
    std::ofstream(path) << text;
  }
  ~TextFile() { std::remove(path.c_str()); }
};

const lab::SearchRange* range_called(const CalibrationStart& start, const std::string& key) {
  for (const auto& range : start.free)
    if (range.key == key) return &range;
  return nullptr;
}

}  // namespace

TEST_CASE("every law that ships ranges has them for numbers it knows, within its own bounds") {
  for (const char* law : {"hypoplastic", "sanisand", "norsand", "cam_clay", "mohr_coulomb"}) {
    const auto start = calibration_start({.law = law});
    CHECK_FALSE(start.free.empty());
    CHECK_NOTHROW(SearchSpace(start.set, start.free));
    for (const auto& range : start.free)
      for (const auto& parameter : start.set.law->parameters)
        if (parameter.key == range.key) {
          INFO(law << " " << range.key);
          CHECK(parameter.range.holds(range.low));
          CHECK(parameter.range.holds(range.high));
        }
  }
}

TEST_CASE("parameters are freed and fixed by name") {
  const auto start = calibration_start(
      {.law = "hypoplastic",
       .start = "hypoplastic/HG99",
       .free = {"peak_exponent", "stiffness_exponent"},
       .fixed = {{"critical_friction_angle_deg", 33.1}, {"stiffness_exponent", std::nullopt}}});
  REQUIRE(start.free.size() == 1);
  CHECK(start.free[0].key == "peak_exponent");
  CHECK(start.set.parameters.numbers.at("critical_friction_angle_deg") == 33.1);
  CHECK_THROWS_WITH(calibration_start({.law = "hypoplast"}), Contains("unknown law 'hypoplast'"));
  CHECK_THROWS_WITH(calibration_start({.law = "hypoplastic", .free = {"peak"}}),
                    Contains("--free 'peak': has no search range"));
  CHECK_THROWS_WITH(calibration_start({.law = "hypoplastic", .start = "sanisand/S28-loose"}),
                    Contains("is a parameter set of sanisand, not of hypoplastic"));
  CHECK_THROWS_WITH(calibration_start({.law = "hypoplastic", .fixed = {{"peak_exponent", -1}}}),
                    Contains("peak_exponent"));
  CHECK_THROWS_WITH(calibration_start({.law = "elastic"}), Contains("under [search]"));
}

TEST_CASE("a parameter file brings its own ranges and what is known beforehand") {
  const TextFile file("calibration_start_test.toml", R"(law = "cam_clay"
[sets.a]
compression_slope = 0.1
swelling_slope = 0.01
critical_stress_ratio = 1.2
poisson_ratio = 0.2
[search]
compression_slope = [0.05, 0.2]
[prior]
compression_slope = [0.11, 0.01]
)");
  const auto start = calibration_start({.law = "cam_clay", .start = file.path + ":a"});
  REQUIRE(start.free.size() == 1);
  CHECK(start.free[0].high == 0.2);
  CHECK(start.free[0].prior->error == 0.01);
  CHECK_THROWS_WITH(calibration_start({.law = "cam_clay", .start = file.path + ":b"}),
                    Contains("no parameter set 'b'"));
  CHECK_THROWS_WITH(calibration_start({.law = "norsand", .start = file.path}),
                    Contains("contains parameter sets of cam_clay, not of norsand"));
}

TEST_CASE("what triax soil measured becomes the start and a prior") {
  const TextFile file("calibration_soil_test.toml", R"(kind = "soil"
version = "1.0.0"
group = ""
notes = []
[friction]
critical_stress_ratio = { value = 1.33, error = 0.01, low = 1.31, high = 1.35, tests = 6 }
critical_friction_angle_deg = { value = 33.1, error = 0.3, low = 32.5, high = 33.7, tests = 6 }
[critical_state_line.power]
critical_void_ratio = { value = 1.04, error = 0.02, low = 1.0, high = 1.08, tests = 6 }
critical_slope = { value = 0.08, error = 0.01, low = 0.06, high = 0.1, tests = 6 }
)");
  const auto hypo = calibration_start({.law = "hypoplastic", .start = file.path});
  CHECK(hypo.set.parameters.numbers.at("critical_friction_angle_deg") == 33.1);
  REQUIRE(range_called(hypo, "critical_friction_angle_deg")->prior);
  CHECK(range_called(hypo, "critical_friction_angle_deg")->prior->error == 0.3);
  CHECK(hypo.notes.size() == 1);
  const auto norsand = calibration_start({.law = "norsand", .start = file.path});
  CHECK(norsand.set.parameters.numbers.at("critical_slope") == 0.08);
  CHECK(range_called(norsand, "critical_stress_ratio")->prior->value == 1.33);
  CHECK_FALSE(range_called(norsand, "hardening_modulus")->prior);
}

TEST_CASE("a measured slope keeps its pressure, and what the law refuses is not taken") {
  const TextFile file("calibration_soil_line_test.toml", R"(kind = "soil"
[critical_state_line.log_linear]
lambda = { value = -0.004, error = 0.02, low = -0.05, high = 0.04, tests = 6 }
[critical_state_line.power]
critical_void_ratio = { value = 1.04, error = 0.02, low = 1.0, high = 1.08, tests = 6 }
critical_slope = { value = 0.004, error = 0.001, low = 0.002, high = 0.006, tests = 6 }
critical_pressure_kPa = 50.0
)");
  const auto norsand = calibration_start({.law = "norsand", .start = file.path});
  CHECK(norsand.set.parameters.numbers.at("critical_pressure_kPa") == 50);
  CHECK(norsand.set.parameters.numbers.at("critical_slope") == 0.004);
  // The range is wider than it ships, and of ratios as it was.
  CHECK(range_called(norsand, "critical_slope")->low == 0.004);
  CHECK(range_called(norsand, "critical_slope")->in_logarithm);

  const auto usual = calibration_start({.law = "sanisand"});
  const auto sanisand = calibration_start({.law = "sanisand", .start = file.path});
  CHECK(sanisand.set.parameters.numbers == usual.set.parameters.numbers);
  REQUIRE(sanisand.notes.size() == 1);
  CHECK_THAT(sanisand.notes[0], Contains("its pressure is 50 kPa, atmospheric_pressure_kPa 100"));

  const auto clay = calibration_start({.law = "cam_clay", .start = file.path});
  CHECK(clay.set.parameters.numbers.at("compression_slope") > 0);
  CHECK(range_called(clay, "compression_slope")->low > 0);
  REQUIRE(clay.notes.size() == 1);
  CHECK_THAT(clay.notes[0], Contains("compression_slope -0.004 ± 0.02") && Contains("not used"));
}

TEST_CASE("a range that a measured value widens beyond ratios is searched in steps") {
  const TextFile file("calibration_soil_zero_test.toml", R"(kind = "soil"
[critical_state_line.power]
critical_slope = { value = 0.0, error = 0.01, low = -0.02, high = 0.02, tests = 6 }
critical_pressure_kPa = 100.0
)");
  const auto start = calibration_start({.law = "sanisand", .start = file.path});
  CHECK(range_called(start, "critical_slope")->low == 0);
  CHECK_FALSE(range_called(start, "critical_slope")->in_logarithm);
  CHECK_NOTHROW(SearchSpace(start.set, start.free));
}
