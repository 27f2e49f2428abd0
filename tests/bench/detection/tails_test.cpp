// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/tails.hpp"

#include <catch2/catch.hpp>

using namespace triax::bench;

TEST_CASE("what is far off is counted by programme") {
  TrialResult collapsed;
  collapsed.programme = "near";
  collapsed.material = "a/b";
  collapsed.collapses = collapsed.truth_lost = true;
  collapsed.outcomes[0].eta_error = 0.001;
  collapsed.outcomes[0].delay = 5;
  std::vector<TrialResult> results(3, collapsed);
  results[1].programme = "late";
  results[1].outcomes[0].delay = -6;
  results[1].outcomes[1].eta_error = 1;  // of another method
  results[2].outcomes[0].eta_error = -0.02;
  results[2].outcomes[0].notice_delay = 801;
  results.push_back({});  // a control
  CHECK(tails(results, {}) ==
        "\nof 3 collapses\n"
        "eta more than 0.01 off                             1\n"
        "    near (a/b)                                     1\n"
        "more than 5 readings off                           1\n"
        "    late (a/b)                                     1\n"
        "noticed after more than 800 readings               1\n"
        "    near (a/b)                                     1\n");
}
