// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/programmes/guard.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "tests/lab/programmes/programme_text.hpp"

using namespace triax::lab;
using Catch::Contains;

namespace {

std::string shear(const std::string& axial) {
  return "[[stages]]\nname = \"shear\"\nrole = \"shear\"\ndrainage = \"closed\"\n" + axial +
         "\nend = [{quantity = \"axial_strain_pct\", above = 1.0}]\n";
}
const std::string kByLoad = shear("axial = \"load\"\nload_rate_N_per_min = 5.0");

Programme guarded(const std::string& keys, const std::string& stages = kByLoad) {
  return read_programme(test::programme_text(stages) + "[guard]\n" + keys, "p.toml");
}

/// "LINE: what is wrong", lines counted from [guard].
std::string complaint_of_guard(const std::string& keys, const std::string& stages = kByLoad) {
  try {
    guarded(keys, stages);
  } catch (const BadInput& error) {
    const std::string text = test::programme_text(stages);
    const auto before = std::ranges::count(text, '\n');
    const std::string told = error.what();
    const std::string file = "p.toml:";
    REQUIRE(told.substr(0, file.size()) == file);
    const auto colon = told.find(':', file.size());
    const long line = std::stol(told.substr(file.size(), colon - file.size()));
    return std::to_string(line - before) + told.substr(colon);
  }
  return "accepted";
}

const std::string kOn = "on = \"imminent\"\n";

}  // namespace

TEST_CASE("a guard is read in SI, with what a laboratory would expect where it says nothing") {
  CHECK_FALSE(read_programme(test::programme_text(kByLoad), "p.toml").guard);
  const Guard handed = *guarded(kOn + "action = \"hand_over\"\nrate_mm_per_min = 0.06\n").guard;
  CHECK(handed.on == WarningLevel::imminent);
  CHECK(handed.action == Guard::Action::hand_over);
  CHECK(handed.rate_m_per_s == Approx(1e-6));
  CHECK(handed.further_strain == 0.02);
  const Guard unloaded = *guarded(
                              "on = \"lost\"\naction = \"unload\"\nrate_mm_per_min = 0.6\nshare = "
                              "0.3\nhold_min = 2.0\n")
                              .guard;
  CHECK(unloaded.on == WarningLevel::lost);
  CHECK(unloaded.share == 0.3);
  CHECK(unloaded.hold_s == 120);
  const Guard further = *guarded(
                             "on = \"approaching\"\naction = \"hand_over\"\n"
                             "rate_mm_per_min = 1\nfurther_strain_pct = 5\n")
                             .guard;
  CHECK(further.on == WarningLevel::approaching);
  CHECK(further.further_strain == Approx(0.05));
  CHECK(guarded(kOn + "action = \"safe\"\n").guard->action == Guard::Action::safe);
}

TEST_CASE("a guard that makes no sense is refused at its line") {
  CHECK(complaint_of_guard("action = \"safe\"\n") == "1: [guard]: on is missing");
  CHECK(complaint_of_guard(kOn) == "1: [guard]: action is missing");
  CHECK_THAT(complaint_of_guard("on = \"none\"\naction = \"safe\"\n"),
             Contains("2: [guard] on") && Contains("must be one of: approaching, imminent, lost"));
  CHECK_THAT(
      complaint_of_guard(kOn + "action = \"handover\"\n"),
      Contains("3: [guard] action") && Contains("must be one of: hand_over, hold, unload, safe"));
  CHECK_THAT(complaint_of_guard(kOn + "action = \"hand_over\"\n"),
             Contains("1: [guard]: rate_mm_per_min is missing"));
  CHECK_THAT(complaint_of_guard(kOn + "action = \"hold\"\nrate_mm_per_min = 1\n"),
             Contains("4: [guard] rate_mm_per_min: has no effect with action = \"hold\""));
  CHECK_THAT(complaint_of_guard(kOn + "action = \"hand_over\"\nrate_mm_per_min = 1\nshare = 0.2\n"),
             Contains("5: [guard] share: has no effect"));
  CHECK_THAT(complaint_of_guard(kOn + "action = \"hand_over\"\nrate_mm_per_min = 1000\n"),
             Contains("4: [guard] rate_mm_per_min: the frame gives"));
  CHECK_THAT(complaint_of_guard(kOn + "action = \"hand_over\"\nrate_mm_per_min = -1\n"),
             Contains("4: [guard] rate_mm_per_min"));
  CHECK_THAT(complaint_of_guard(kOn + "action = \"safe\"\nwhen = 3\n"),
             Contains("4: ") && Contains("when"));
}

TEST_CASE("hand_over needs a stage in which something else than the crosshead holds the load") {
  const std::string hand_over = kOn + "action = \"hand_over\"\nrate_mm_per_min = 0.1\n";
  const std::string by_displacement =
      shear("axial = \"displacement\"\naxial_rate_mm_per_min = 1.0");
  CHECK_THAT(complaint_of_guard(hand_over, by_displacement),
             Contains("3: [guard] action: no shear stage"));
  CHECK(complaint_of_guard(kOn + "action = \"hold\"\n", by_displacement) == "accepted");
  for (const char* axial :
       {"axial = \"dead_load\"", "axial = \"constant_q\"",
        "axial = \"stress_ratio\"\nheld_stress_ratio = 0.5",
        "axial = \"spring\"\nspring_stiffness_N_per_mm = 100\naxial_rate_mm_per_min = 0.5"})
    CHECK(complaint_of_guard(hand_over, shear(axial)) == "accepted");
  CHECK_THAT(complaint_of_guard(kOn + "action = \"safe\"\n", shear("axial = \"free\"")),
             Contains("3: [guard] action: no stage is a shear stage with a piston"));
}
