// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_progress.hpp"

#include <catch2/catch.hpp>

using namespace triax::sim;

TEST_CASE("Grain progress: without a listener work goes on, with one as it says") {
  CHECK(goes_on({}, 0.5, "work"));
  std::string heard;
  const GrainProgress no = [&](double, const std::string& what) {
    heard = what;
    return false;
  };
  CHECK_FALSE(goes_on(no, 0.5, "work"));
  CHECK(heard == "work");
}
