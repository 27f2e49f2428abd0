// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/kernels.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/grains/packings.hpp"
#include "tests/sim/grains/pair_range.hpp"

using namespace triax::sim;
using triax::sim::test::range_of;
using triax::sim::test::same_bytes;

TEST_CASE("Grains: the portable loops are always there, and the best ones are available") {
  CHECK(available(InstructionSet::portable));
  CHECK(available(best_instruction_set()));
  CHECK(kernels(best_instruction_set()).pairs != nullptr);
}

TEST_CASE("Grains: loops of every instruction set give the same bits, whatever is left over") {
  const auto set = GENERATE(InstructionSet::avx2, InstructionSet::avx512);
  if (!available(set)) {
    WARN("this processor has not every instruction set: skipped");
    return;
  }
  for (int left = 0; left < 9; ++left) {
    GrainState a = test::lattice(5);
    test::shake(a, 0.5);
    GrainState b = a;
    AlignedVector<GrainLoad> loads_a(a.grains.size()), loads_b(a.grains.size());
    PairRange ra = range_of(a, loads_a), rb = range_of(b, loads_b);
    ra.end -= left;
    rb.end -= left;
    for (int s = 0; s < 3; ++s) {
      kernels(InstructionSet::portable).pairs(ra);
      kernels(set).pairs(rb);
    }
    CHECK(same_bytes(loads_a, loads_b));
    for (int x = 0; x < 3; ++x)
      CHECK(same_bytes(a.neighbours.near.tangential_n[x], b.neighbours.near.tangential_n[x]));
    const auto count = static_cast<std::int64_t>(a.grains.size());
    const FastestTwo fa = kernels(InstructionSet::portable)
                              .motion({a.grains.data(), loads_a.data(), count, 1e-6, 0.2});
    const FastestTwo fb = kernels(set).motion({b.grains.data(), loads_b.data(), count, 1e-6, 0.2});
    CHECK(same_bytes(a.grains, b.grains));
    CHECK(same_bytes(loads_a, AlignedVector<GrainLoad>(a.grains.size())));
    CHECK(same_bytes(loads_b, loads_a));
    CHECK(fa.first == fb.first);
    CHECK(fa.second == fb.second);
    CHECK(fa.first > fa.second);
  }
}

TEST_CASE("Grains: damping brakes what moves along its force and the two fastest are found") {
  AlignedVector<Grain> grains(3);
  AlignedVector<GrainLoad> loads(3);
  for (Grain& g : grains) g.inverse_mass = g.inverse_inertia = 2;
  grains[0].velocity[0] = 1;
  grains[1].velocity[1] = -3;
  grains[2].velocity[2] = 2;
  loads[0].force[0] = 10;
  loads[1].force[1] = 10;
  const FastestTwo f = portable_motion({grains.data(), loads.data(), 3, 1e-3, 0.25});
  CHECK(grains[0].velocity[0] == Approx(1 + 0.75 * 0.02));
  CHECK(grains[1].velocity[1] == Approx(-3 + 1.25 * 0.02));
  CHECK(grains[0].position[0] == Approx(1e-3 * grains[0].velocity[0]));
  CHECK(std::sqrt(f.first) == Approx(3 - 1.25 * 0.02));
  CHECK(std::sqrt(f.second) == Approx(2));
}
