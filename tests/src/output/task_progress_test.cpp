// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/task_progress.hpp"

#include <catch2/catch.hpp>

using triax::src::task_progress_text;

TEST_CASE("progress of tasks says what is done, how much of it, and how long it will take") {
  CHECK(task_progress_text(2, 7, "R 0.825", 0.4, "following the path", 40) ==
        "2/7 R 0.825: following the path, 40 %, 60.0 s left");
  CHECK(task_progress_text(1, 7, "specimen", 0.001, "compressing", 40) ==
        "1/7 specimen: compressing, 0 %");
  CHECK(task_progress_text(1, 1, "x", 2, "y", 10) == "1/1 x: y, 100 %, 0.0 s left");
}
