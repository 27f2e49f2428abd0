// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/rig_file.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "tests/lab/wire/served_bench.hpp"

using namespace triax::lab;
using namespace triax::lab::test;
using Catch::Contains;

namespace {

std::string refusal(const std::string& text) {
  try {
    parse_rig_file(text, "rig.toml");
  } catch (const BadInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a rig's file says where each instrument is and what its channels measure") {
  const RigFile rig = parse_rig_file(rig_text(), "dir/rig.toml");
  CHECK(rig.instruments.size() == 4);
  CHECK(rig.plant->programme == "dir/p.toml");
  CHECK(rig.with(RigRole::back)->name == "back");
  CHECK(rig.find("frame")->link.kind == LinkAddress::Kind::tcp);
  const RigChannel& force = *rig.channel(Quantity::axial_force);
  CHECK(force.asked.at == 102);
  CHECK(force.unit == "N");
  CHECK(force.scale == 1);
  CHECK(rig.channel(Quantity::cell_pressure)->scale == 1e3);
  CHECK(rig.channel(Quantity::back_volume)->asked.point == "volume_mm3");
  CHECK(rig.channel(Quantity::back_volume)->scale == Approx(1e-9));
  CHECK(force.calibration.gain == 1000);
}

TEST_CASE("what a rig's file must not say is refused with its line") {
  const auto instead = [](const std::string& from, const std::string& to) {
    return refusal(replaced(rig_text(), from, to));
  };
  CHECK_THAT(refusal("[rig]\nname = \"a\"\n"), Contains("write [[instruments]]"));
  CHECK_THAT(instead("role = \"frame\"", "role = \"frme\""), Contains("frame") && Contains(":"));
  CHECK_THAT(instead("role = \"back\"", "role = \"cell\""),
             Contains("another instrument has the role"));
  CHECK_THAT(instead("name = \"frame\"", "name = \"scanner\""),
             Contains("another instrument has the name"));
  CHECK_THAT(instead("quantity = \"cell_volume\"", "quantity = \"back_volume\""),
             Contains("assigned to two channels"));
  CHECK_THAT(instead("unit = \"N\"", "unit = \"mm\""), Contains("is not a unit of axial_force"));
  CHECK_THAT(instead("at = \"volume_mm3\"", "at = \"volume\""), Contains("volume"));
  CHECK_THAT(instead("personality = \"34970A\"", "personality = \"34971A\""), Contains("34970A"));
  CHECK_THAT(instead("link = \"tcp://127.0.0.1:0\"", "link = \"modbus-tcp://127.0.0.1:0/1\""),
             Contains("has no Modbus"));
  CHECK_THAT(instead("link = \"tcp://127.0.0.1:0\"", "link = \"127.0.0.1\""), Contains("tcp://"));
  CHECK_THAT(instead("watchdog_s = 1.0", "watchdog = 1.0"), Contains("watchdog_s"));
  CHECK_THAT(instead("gain = 5.0", "gain = 0.0"), Contains("gain"));
}
