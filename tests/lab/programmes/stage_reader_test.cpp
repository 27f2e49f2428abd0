// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/stage_reader.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {
/// What the reader says of one stage with these lines.
std::string complaint_of_stage(const std::string& lines) {
  const std::string stage =
      "[[stages]]\nname = \"s\"\nrole = \"shear\"\ndrainage = \"open\"\n" + lines;
  try {
    read_programme(test::programme_text(stage), "p.toml");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}
const std::string kEnd = "end = [{quantity = \"time_min\", above = 5}]\n";
}  // namespace

TEST_CASE("sound stages are accepted") {
  CHECK(complaint_of_stage("axial = \"free\"\ncell_rate_kPa_per_min = 10\ncell_target_kPa = 500\n"
                           "end = [{quantity = \"cell_pressure_kPa\", above = 500}]\n") ==
        "accepted");
  CHECK(complaint_of_stage("axial = \"constant_q\"\nback_rate_kPa_per_min = 1\n" + kEnd) ==
        "accepted");
  CHECK(complaint_of_stage("axial = \"displacement\"\naxial_rate_mm_per_min = -0.1\n" + kEnd) ==
        "accepted");
}

TEST_CASE("a stage must say what the axis does, at a rate the frame has") {
  CHECK_THAT(complaint_of_stage(kEnd), Contains("axial is missing"));
  CHECK_THAT(complaint_of_stage("axial = \"constant\"\n" + kEnd), Contains("constant_q"));
  CHECK_THAT(complaint_of_stage("axial = \"displacement\"\naxial_rate_mm_per_min = 0\n" + kEnd),
             Contains("is 0"));
  CHECK_THAT(complaint_of_stage("axial = \"displacement\"\naxial_rate_mm_per_min = 60\n" + kEnd),
             Contains("p.toml:19") && Contains("5.99999"));
  CHECK_THAT(complaint_of_stage("axial = \"free\"\naxial_rate_mm_per_min = 1\n" + kEnd),
             Contains("unknown key 'axial_rate_mm_per_min' in [stages 1]"));
}

TEST_CASE("an end that can never come is refused") {
  CHECK_THAT(complaint_of_stage("axial = \"free\"\n"), Contains("has no end"));
  CHECK_THAT(complaint_of_stage(
                 "axial = \"free\"\nend = [{quantity = \"cell_pressure_kPa\", above = 500}]\n"),
             Contains("never reaches 500 kPa"));
  CHECK_THAT(
      complaint_of_stage("axial = \"free\"\ncell_rate_kPa_per_min = 10\ncell_target_kPa = 450\n"
                         "end = [{quantity = \"cell_pressure_kPa\", above = 500}]\n"),
      Contains("never reaches"));
  CHECK_THAT(complaint_of_stage(
                 "axial = \"free\"\ncell_rate_kPa_per_min = -10\ncell_target_kPa = 450\n" + kEnd),
             Contains("sign of cell_rate_kPa_per_min is wrong"));
  CHECK_THAT(complaint_of_stage("axial = \"free\"\nend = [{quantity = \"time_s\", below = 5}]\n"),
             Contains("time only increases"));
  CHECK_THAT(complaint_of_stage("axial = \"free\"\ntime_limit_min = 4\n" + kEnd),
             Contains("never reache"));
  CHECK_THAT(
      complaint_of_stage("axial = \"free\"\nend = [{quantity = \"stress_ratio\", above = 4}]\n"),
      Contains("at most 3"));
  CHECK_THAT(
      complaint_of_stage("axial = \"free\"\nend = [{quantity = \"axial_strain\", above = 4}]\n"),
      Contains("did you mean 'axial_strain_pct'?"));
  CHECK_THAT(complaint_of_stage("axial = \"free\"\nend = [{quantity = \"q_kPa\"}]\n"),
             Contains("exactly one of above and below"));
  CHECK_THAT(complaint_of_stage("axial = \"displacement\"\naxial_rate_mm_per_min = -1\n"
                                "end = [{quantity = \"axial_strain_pct\", above = 4}]\n"),
             Contains("in the other direction"));
}

TEST_CASE("a pressure demand has a rate that its controller has") {
  CHECK_THAT(complaint_of_stage("axial = \"free\"\nback_target_kPa = 400\n" + kEnd),
             Contains("needs back_rate_kPa_per_min"));
  CHECK_THAT(complaint_of_stage("axial = \"free\"\nback_rate_kPa_per_min = 0\n" + kEnd),
             Contains("hold"));
  CHECK_THAT(complaint_of_stage("axial = \"free\"\nback_rate_kPa_per_min = 1e6\n" + kEnd),
             Contains("at most"));
}

TEST_CASE("every way of moving the axis has its own keys") {
  for (const char* good :
       {"axial = \"hold\"\n", "axial = \"dead_load\"\nimpulse_N_s = 0.05\n",
        "axial = \"load\"\nload_rate_N_per_min = 5\nload_step_N = 1\n",
        "axial = \"spring\"\naxial_rate_mm_per_min = 0.1\nspring_stiffness_N_per_mm = 50\n",
        "axial = \"stress_ratio\"\nheld_stress_ratio = 0.5\n",
        "axial = \"displacement\"\naxial_rate_mm_per_min = 0.1\nstrain_path_R = 0.8\n"})
    CHECK(complaint_of_stage(good + kEnd) == "accepted");
  CHECK_THAT(complaint_of_stage("axial = \"spring\"\naxial_rate_mm_per_min = 0.1\n" + kEnd),
             Contains("spring_stiffness_N_per_mm is missing"));
  CHECK_THAT(complaint_of_stage("axial = \"displacement\"\naxial_rate_mm_per_min = 0\n" + kEnd),
             Contains("is 0; give a rate or write axial = \"hold\""));
  CHECK_THAT(complaint_of_stage("axial = \"load\"\nload_rate_N_per_min = 0\n" + kEnd),
             Contains("write axial = \"dead_load\""));
  CHECK_THAT(complaint_of_stage("axial = \"stress_ratio\"\nheld_stress_ratio = 3\n" + kEnd),
             Contains("held_stress_ratio"));
  CHECK_THAT(complaint_of_stage(
                 "axial = \"displacement\"\naxial_rate_mm_per_min = 0.1\nload_step_N = 1\n" + kEnd),
             Contains("unknown key 'load_step_N'"));
  CHECK_THAT(
      complaint_of_stage("axial = \"displacement\"\naxial_rate_mm_per_min = 0.1\nstrain_path_R = "
                         "0.8\nback_rate_kPa_per_min = 1\n" +
                         kEnd),
      Contains("cannot follow strain_path_R as well"));
}

TEST_CASE("a stage is logged as it says, else as the test is") {
  const std::string free = "axial = \"free\"\n" + kEnd;
  const auto logging = [](const std::string& lines) {
    return read_programme(test::programme_text("[[stages]]\nname = \"s\"\nrole = \"shear\"\n"
                                               "drainage = \"open\"\n" +
                                               lines),
                          "p.toml")
        .stages[0]
        .logging;
  };
  const double of_the_test = logging(free).interval_s;
  CHECK(logging("scan_interval_s = 30\naveraging_s = 10\n" + free).interval_s == 30);
  CHECK(logging("scan_interval_s = 30\naveraging_s = 10\n" + free).averaging_s == 10);
  CHECK(logging("averaging_s = 0.5\n" + free).interval_s == of_the_test);
  CHECK(logging(free).averaging_s == 0);
  CHECK_THAT(complaint_of_stage("scan_interval_s = 5\naveraging_s = 6\n" + free),
             Contains("cannot be averaged over 6 s") && Contains("averaging_s = 5 or less"));
  CHECK_THAT(complaint_of_stage("scan_interval_s = 0\n" + free), Contains("scan_interval_s"));
  CHECK_THAT(complaint_of_stage("averaging_s = -1\n" + free), Contains("averaging_s"));
}
