#include "sim/grains/kernels.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "tests/sim/grains/packings.hpp"

using namespace triax::sim;

namespace {

PairRange range_of(GrainState& s, AlignedVector<GrainLoad>& loads) {
  NearPairs& near = s.neighbours.near;
  PairRange r{};
  r.grains = s.grains.data();
  r.loads = loads.data();
  r.end = static_cast<std::int64_t>(near.size());
  r.i = near.i.data();
  r.j = near.j.data();
  r.tx = near.tangential_n[0].data();
  r.ty = near.tangential_n[1].data();
  r.tz = near.tangential_n[2].data();
  r.stiffness = near.stiffness_n_per_m.data();
  r.reach = near.reach_m.data();
  r.half_difference = near.half_difference_m.data();
  r.friction_coefficient = 0.3;
  r.tangential_step = 0.42e-6;
  r.half_step = 0.5e-6;
  return r;
}

bool same(const auto& a, const auto& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

}  // namespace

TEST_CASE("Grains: the portable loops are always there, and the best ones are available") {
  CHECK(available(InstructionSet::portable));
  CHECK(available(best_instruction_set()));
  CHECK(kernels(best_instruction_set()).pairs != nullptr);
}

TEST_CASE("Grains: loops of every instruction set give the same bits, whatever is left over") {
  if (!available(InstructionSet::avx2)) {
    WARN("this processor has no AVX2: skipped");
    return;
  }
  for (int left = 0; left < 4; ++left) {
    GrainState a = test::lattice(5);
    test::shake(a, 0.5);
    GrainState b = a;
    AlignedVector<GrainLoad> loads_a(a.grains.size()), loads_b(a.grains.size());
    PairRange ra = range_of(a, loads_a), rb = range_of(b, loads_b);
    ra.end -= left;
    rb.end -= left;
    for (int s = 0; s < 3; ++s) {
      kernels(InstructionSet::portable).pairs(ra);
      kernels(InstructionSet::avx2).pairs(rb);
    }
    CHECK(same(loads_a, loads_b));
    for (int x = 0; x < 3; ++x)
      CHECK(same(a.neighbours.near.tangential_n[x], b.neighbours.near.tangential_n[x]));
    const auto count = static_cast<std::int64_t>(a.grains.size());
    const FastestTwo fa = kernels(InstructionSet::portable)
                              .motion({a.grains.data(), loads_a.data(), count, 1e-6, 0.2});
    const FastestTwo fb =
        kernels(InstructionSet::avx2).motion({b.grains.data(), loads_b.data(), count, 1e-6, 0.2});
    CHECK(same(a.grains, b.grains));
    CHECK(same(loads_a, AlignedVector<GrainLoad>(a.grains.size())));
    CHECK(same(loads_b, loads_a));
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
