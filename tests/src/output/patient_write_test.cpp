// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/patient_write.hpp"

#include <catch2/catch.hpp>

#include "lab/base/whole_file.hpp"

using namespace triax;
using namespace triax::src;

TEST_CASE("a full disk is waited for until it has room, or until the run is to stop") {
  int tries = 0;
  const auto full_twice = [&] {
    if (++tries < 3) throw lab::NoRoom("a.grains: No space left on device");
  };
  write_when_there_is_room(full_twice, {});
  CHECK(tries == 3);

  tries = 0;
  CHECK_THROWS_AS(write_when_there_is_room(full_twice, [&] { return tries == 2; }), lab::NoRoom);
  CHECK(tries == 2);
}

TEST_CASE("what no waiting changes is told at once") {
  int tries = 0;
  const auto forbidden = [&] {
    ++tries;
    throw lab::WorkFailed("a.grains: Permission denied");
  };
  CHECK_THROWS_AS(write_when_there_is_room(forbidden, {}), lab::WorkFailed);
  CHECK(tries == 1);
}
