// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/course_evidence.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// Evidence for the same sign of a displacement (mm) and a load (kN).
double evidence_of(std::vector<double> displacement, std::vector<double> load) {
  const Identity identity{.lowest = -1, .highest = 1};
  const Series x{std::move(displacement), 0.005}, y{std::move(load), 0.0005};
  const std::array<const Series*, 2> series{&x, &y};
  return common_direction_evidence(identity, series, {});
}

}  // namespace

TEST_CASE("common_direction_evidence: load and deformation grow together") {
  CHECK(evidence_of({0, 1, 2, 3, 4, 5, 6, 7}, {0, .1, .2, .3, .4, .4, .4, .3}) == 1);
  CHECK(evidence_of({0, -1, -2, -3, -4, -5, -6, -7}, {0, .1, .2, .3, .4, .4, .4, .3}) == -1);
}

TEST_CASE("common_direction_evidence: a specimen that is consolidated and then extended") {
  const std::vector<double> load{0, 0, .001, 0, 0, -.1, -.2, -.3};
  CHECK(evidence_of({0, 2, 4, 5, 5, 4.9, 4.5, 4}, load) == 1);
  CHECK(evidence_of({0, 2, 4, 5, 5, 5.1, 5.5, 6}, load) == -1);
}
