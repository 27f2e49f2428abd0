// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sweep_progress.hpp"

#include <catch2/catch.hpp>

using namespace triax::src;
using namespace triax::study;

TEST_CASE("the progress of a sweep tells counts, failures and the time that is left") {
  CHECK(progress_text({.done = 0, .failed = 0}, 200, 5) == "0 of 200 tests");
  CHECK(progress_text({.done = 50, .failed = 0}, 200, 10) == "50 of 200 tests, 30.0 s left");
  CHECK(progress_text({.done = 50, .failed = 2}, 200, 1000) ==
        "50 of 200 tests, 2 failed, 50.0 min left");
}
