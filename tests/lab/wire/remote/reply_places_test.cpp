// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/reply_places.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// A pressure of an instrument that says 2 per kPa, downwards.
RigInstrument instrument(const std::string& personality) {
  RigInstrument one;
  one.personality = find_personality(personality);
  RigChannel channel;
  channel.quantity = Quantity::cell_pressure;
  channel.name = "cell_pressure";
  channel.scale = 1e3;
  channel.calibration.gain = -0.5;
  one.channels = {channel};
  return one;
}

}  // namespace

TEST_CASE("reply_places: no apparatus measures 1 GPa") {
  const auto places = reply_places(instrument("34970A"), {{.point = {}, .at = 101}});
  REQUIRE(places.size() == 1);
  CHECK(places[0].name == "cell_pressure");
  CHECK(places[0].possible == std::pair(-2e6, 2e6));
  CHECK(places[0].calibrated == ReplyPlace().calibrated);
}

TEST_CASE("reply_places: the range of the calibration is that of the instrument's numbers") {
  RigInstrument one = instrument("34970A");
  one.channels[0].calibration.offset = 10;
  one.channels[0].calibration.range = {0, 1000};
  CHECK(reply_places(one, {{.point = {}, .at = 101}})[0].calibrated == std::pair(-1980.0, 20.0));
}

TEST_CASE("reply_places: the personality limits what its instrument can give") {
  RigInstrument pad = instrument("pad");
  pad.channels[0].calibration.gain = 1e-5;
  CHECK(reply_places(pad, {{.point = {}, .at = 1}})[0].possible ==
        std::pair(-8388608.0, 8388607.0));
  const auto states = reply_places(instrument("triax-frame"),
                                   {{.point = "force_N", .at = {}}, {.point = "state", .at = {}}});
  CHECK(states[1].name == "state");
  CHECK(states[1].possible == std::pair(0.0, 5.0));
}
