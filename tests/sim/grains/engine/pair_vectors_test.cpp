// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/pair_vectors.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sim/grains/packings.hpp"
#include "tests/sim/grains/pair_range.hpp"

using namespace triax::sim;
using triax::sim::test::range_of;
using triax::sim::test::same_bytes;

namespace {

/// Vectors of three, by the language's own means.
struct Three {
  static constexpr int kLanes = 3;
  struct Mask {
    bool at[kLanes];
  };
  struct V {
    double at[kLanes];
    friend V operator+(V a, V b) {
      return each([&](int q) { return a.at[q] + b.at[q]; });
    }
    friend V operator-(V a, V b) {
      return each([&](int q) { return a.at[q] - b.at[q]; });
    }
    friend V operator*(V a, V b) {
      return each([&](int q) { return a.at[q] * b.at[q]; });
    }
    friend V operator/(V a, V b) {
      return each([&](int q) { return a.at[q] / b.at[q]; });
    }
  };
  static V each(const auto& value) { return {{value(0), value(1), value(2)}}; }

  static V load(const double* p) {
    return each([&](int q) { return p[q]; });
  }
  static void store(double* p, V v) {
    for (int q = 0; q < kLanes; ++q) p[q] = v.at[q];
  }
  static V every(double x) {
    return each([&](int) { return x; });
  }
  static V root(V v) {
    return each([&](int q) { return std::sqrt(v.at[q]); });
  }
  static Mask less(V a, V b) { return {{a.at[0] < b.at[0], a.at[1] < b.at[1], a.at[2] < b.at[2]}}; }
  static Mask both(Mask m, Mask n) {
    return {{m.at[0] && n.at[0], m.at[1] && n.at[1], m.at[2] && n.at[2]}};
  }
  static V keep(Mask m, V v) {
    return each([&](int q) { return m.at[q] ? v.at[q] : 0; });
  }
  static V pick(Mask m, V a, V b) {
    return each([&](int q) { return m.at[q] ? a.at[q] : b.at[q]; });
  }
  static bool any(V v) { return v.at[0] != 0 || v.at[1] != 0 || v.at[2] != 0; }
  static Columns<Three> columns(const Grain* const g[kLanes], int row) {
    const auto along = [&](int x) {
      return each([&](int q) {
        const double* rows[] = {g[q]->position, g[q]->velocity, g[q]->spin};
        return rows[row][x];
      });
    };
    return {along(0), along(1), along(2)};
  }
  static Columns<Three> columns_between(const Grain* const from[kLanes],
                                        const Grain* const to[kLanes], int row) {
    return columns(to, row) - columns(from, row);
  }
  static void add_loads(const PairRange& r, std::int64_t k, const Columns<Three>& force,
                        const Columns<Three>& moment, V arm_a, V arm_b) {
    const V f[3]{force.x, force.y, force.z}, m[3]{moment.x, moment.y, moment.z};
    for (int q = 0; q < kLanes; ++q)
      for (int x = 0; x < 3; ++x) {
        GrainLoad &on_a = r.loads[r.i[k + q]], &on_b = r.loads[r.j[k + q]];
        on_a.force[x] += f[x].at[q];
        on_b.force[x] -= f[x].at[q];
        on_a.moment[x] += m[x].at[q] * arm_a.at[q];
        on_b.moment[x] += m[x].at[q] * arm_b.at[q];
      }
  }
};

}  // namespace

TEST_CASE("Grains: vectors of pairs give the bits of pairs one by one, whatever is left over") {
  for (int left = 0; left < 30; left += 7) {
    GrainState a = test::lattice(5);
    test::shake(a, 0.5);
    GrainState b = a;
    AlignedVector<GrainLoad> loads_a(a.grains.size()), loads_b(a.grains.size());
    PairRange ra = range_of(a, loads_a), rb = range_of(b, loads_b);
    ra.end -= left;
    rb.end -= left;
    double taken_a = 0, taken_b = 0;
    if (left > 0) {
      ra.friction_j = &taken_a;
      rb.friction_j = &taken_b;
    }
    for (int s = 0; s < 3; ++s) {
      portable_pairs(ra);
      PairVectors<Three>::run(rb);
    }
    CHECK(same_bytes(loads_a, loads_b));
    CHECK(taken_a == taken_b);
    CHECK((taken_a > 0) == (left > 0));
    for (int x = 0; x < 3; ++x)
      CHECK(same_bytes(a.neighbours.near.tangential_n[x], b.neighbours.near.tangential_n[x]));
    CHECK_FALSE(same_bytes(loads_a, AlignedVector<GrainLoad>(a.grains.size())));
  }
}

TEST_CASE("Grains: fewer pairs than a vector holds are not passed over") {
  GrainState s = test::pair_of(1e-3, 1e-3, 1e-5, {}, 1e-7);
  AlignedVector<GrainLoad> loads(2);
  PairVectors<Three>::run(range_of(s, loads));
  CHECK(loads[0].force[0] == Approx(-s.neighbours.near.stiffness_n_per_m[0] * 1e-5));
  CHECK(loads[1].force[0] == -loads[0].force[0]);
}
