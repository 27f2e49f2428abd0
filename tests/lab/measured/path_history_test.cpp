// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/path_history.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;

namespace {

PathHistory straight_line(int readings) {
  PathHistory history;
  for (int i = 0; i < readings; ++i) {
    PathSample s;
    s.signal[PathSample::reading] = i;
    s.signal[PathSample::q] = 3.0 * i;
    history.add(s);
  }
  return history;
}

}  // namespace

TEST_CASE("the recent past is there reading by reading") {
  const auto blocks = straight_line(10000).between(9900, 9950);
  REQUIRE(blocks.size() == 51);
  CHECK(blocks.front().signal[PathSample::reading] == 9900);
  CHECK(blocks.back().signal[PathSample::q] == 3 * 9950);
}

TEST_CASE("farther back the past is there in coarser blocks, whose means lie on the line") {
  const PathHistory history = straight_line(100000);
  for (const double back : {300.0, 3000.0, 30000.0, 99000.0}) {
    const auto blocks = history.between(100000 - back, 100000 - back / 2);
    CHECK(blocks.size() >= PathHistory::kBlocks / 4 - 1);
    CHECK(blocks.size() <= PathHistory::kBlocks);
    for (const PathSample& b : blocks)
      CHECK(b.signal[PathSample::q] == Approx(3 * b.signal[PathSample::reading]));
    for (std::size_t i = 1; i < blocks.size(); ++i)
      CHECK(blocks[i].signal[PathSample::reading] > blocks[i - 1].signal[PathSample::reading]);
  }
}

TEST_CASE("what was cleared is forgotten") {
  PathHistory history = straight_line(100);
  CHECK(history.last_reading() == 99);
  history.clear();
  CHECK(history.between(0, 1000).empty());
  CHECK(std::isnan(history.last_reading()));
}
