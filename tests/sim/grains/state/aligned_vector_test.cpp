// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/aligned_vector.hpp"

#include <catch2/catch.hpp>
#include <cstdint>

using namespace triax::sim;

TEST_CASE("Grains: an aligned vector starts a cache line, also once it has grown") {
  AlignedVector<double> v;
  for (int i = 0; i < 1000; ++i) {
    v.push_back(i);
    REQUIRE(reinterpret_cast<std::uintptr_t>(v.data()) % 64 == 0);
  }
  CHECK(v[999] == 999);
}
