// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/kernels.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

#include "sim/grains/engine/pair_vectors.hpp"

namespace triax::sim {
namespace {

struct Avx2 {
  using V = __m256d;
  using Mask = __m256d;
  static constexpr int kLanes = 4;

  static V load(const double* p) { return _mm256_load_pd(p); }
  static void store(double* p, V v) { _mm256_store_pd(p, v); }
  static V every(double x) { return _mm256_set1_pd(x); }
  static V root(V v) { return _mm256_sqrt_pd(v); }
  static Mask less(V a, V b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
  static Mask both(Mask m, Mask n) { return _mm256_and_pd(m, n); }
  static V keep(Mask m, V v) { return _mm256_and_pd(v, m); }
  static V pick(Mask m, V a, V b) { return _mm256_blendv_pd(b, a, m); }
  static bool any(V v) {
    return _mm256_movemask_pd(_mm256_cmp_pd(v, _mm256_setzero_pd(), _CMP_NEQ_UQ)) != 0;
  }

  static V halves(const double* low, const double* high) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(low)), _mm_load_pd(high), 1);
  }
  static Columns<Avx2> columns(const Grain* const g[kLanes], int row) {
    const double *a = row_of(g[0], row), *b = row_of(g[1], row), *c = row_of(g[2], row),
                 *d = row_of(g[3], row);
    const V ac = halves(a, c), bd = halves(b, d);
    const V ac_z = halves(a + 2, c + 2), bd_z = halves(b + 2, d + 2);
    return {_mm256_unpacklo_pd(ac, bd), _mm256_unpackhi_pd(ac, bd), _mm256_unpacklo_pd(ac_z, bd_z)};
  }
  static Columns<Avx2> columns_between(const Grain* const from[kLanes],
                                       const Grain* const to[kLanes], int row) {
    const auto difference = [&](int q) {
      return load(row_of(to[q], row)) - load(row_of(from[q], row));
    };
    const V a = difference(0), b = difference(1), c = difference(2), d = difference(3);
    const V ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b),
            cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
    return {_mm256_permute2f128_pd(ab0, cd0, 0x20), _mm256_permute2f128_pd(ab1, cd1, 0x20),
            _mm256_permute2f128_pd(ab0, cd0, 0x31)};
  }

  /// Rows x, y, z, 0.
  static void to_rows(const Columns<Avx2>& c, V rows[kLanes]) {
    const V zero = _mm256_setzero_pd();
    const V xy0 = _mm256_unpacklo_pd(c.x, c.y), xy1 = _mm256_unpackhi_pd(c.x, c.y),
            z0 = _mm256_unpacklo_pd(c.z, zero), z1 = _mm256_unpackhi_pd(c.z, zero);
    rows[0] = _mm256_permute2f128_pd(xy0, z0, 0x20);
    rows[1] = _mm256_permute2f128_pd(xy1, z1, 0x20);
    rows[2] = _mm256_permute2f128_pd(xy0, z0, 0x31);
    rows[3] = _mm256_permute2f128_pd(xy1, z1, 0x31);
  }
  static void add_loads(const PairRange& r, std::int64_t k, const Columns<Avx2>& force,
                        const Columns<Avx2>& moment, V arm_a, V arm_b) {
    V forces[kLanes], moments_a[kLanes], moments_b[kLanes];
    to_rows(force, forces);
    to_rows(moment * arm_a, moments_a);
    to_rows(moment * arm_b, moments_b);
    for (int q = 0; q < kLanes; ++q) {
      GrainLoad& on_a = r.loads[r.i[k + q] - r.first_grain];
      GrainLoad& on_b = r.loads[r.j[k + q] - r.first_grain];
      store(on_a.force, load(on_a.force) + forces[q]);
      store(on_a.moment, load(on_a.moment) + moments_a[q]);
      store(on_b.force, load(on_b.force) - forces[q]);
      store(on_b.moment, load(on_b.moment) + moments_b[q]);
    }
  }
};

/// Sums of one row, velocity or spin.
struct RowSums {
  __m256d kinetic = _mm256_setzero_pd(), before = kinetic, after = kinetic, momentum = kinetic,
          braked = kinetic;

  void add(__m256d v, __m256d tried, __m256d next, const double& inverse) {
    const __m256d inertia = _mm256_set1_pd(1) / _mm256_broadcast_sd(&inverse);
    const __m256d taken = inertia * (tried - next), half = _mm256_set1_pd(0.5);
    kinetic = kinetic + half * inertia * v * next;
    before = before + half * taken * v;
    after = after + half * taken * next;
    momentum = momentum + inertia * next;
    braked = braked + taken;
  }
  void put(MotionSums& sums, int from) const {
    _mm256_storeu_pd(sums.kinetic + from, kinetic);
    _mm256_storeu_pd(sums.damping_before + from, before);
    _mm256_storeu_pd(sums.damping_after + from, after);
    _mm256_storeu_pd(sums.momentum + from, momentum);
    _mm256_storeu_pd(sums.braked + from, braked);
  }
};

template <bool kBooked>
FastestTwo motion_as(const GrainRange& range) {
  using V = __m256d;
  const auto row = [](double x) { return _mm256_setr_pd(x, x, x, 0); };  // 1/m and 1/I stay
  const V step = row(range.time_step), half = row(0.5 * range.time_step);
  const V damping = row(range.damping), sign = _mm256_set1_pd(-0.0), zero = _mm256_setzero_pd();
  const auto next = [&](V v, V a) {
    const V brake = _mm256_andnot_pd(sign, damping * a);
    return v + step * (a - _mm256_or_pd(brake, _mm256_and_pd(v + half * a, sign)));
  };
  __m128d first = _mm_setzero_pd(), second = first;
  RowSums of_velocity, of_spin;
  Grain* grains = range.grains;
  GrainLoad* loads = range.loads;
  const std::int64_t count = range.count;
  for (std::int64_t i = 0; i < count; ++i) {
    Grain& g = grains[i];
    GrainLoad& load = loads[i];
    const V pull = _mm256_load_pd(load.force) * _mm256_broadcast_sd(&g.inverse_mass),
            twist = _mm256_load_pd(load.moment) * _mm256_broadcast_sd(&g.inverse_inertia);
    const V v_before = _mm256_load_pd(g.velocity), w_before = _mm256_load_pd(g.spin);
    const V v = next(v_before, pull), w = next(w_before, twist);
    if constexpr (kBooked) {
      of_velocity.add(v_before, v_before + step * pull, v, g.inverse_mass);
      of_spin.add(w_before, w_before + step * twist, w, g.inverse_inertia);
    }
    _mm256_store_pd(g.velocity, v);
    _mm256_store_pd(g.spin, w);
    _mm256_store_pd(g.position, _mm256_load_pd(g.position) + step * v);
    _mm256_store_pd(load.force, zero);
    _mm256_store_pd(load.moment, zero);
    const V squares = v * v;
    const __m128d xy = _mm256_castpd256_pd128(squares);
    const __m128d speed =
        _mm_add_sd(_mm_add_sd(xy, _mm_unpackhi_pd(xy, xy)), _mm256_extractf128_pd(squares, 1));
    second = _mm_max_sd(second, _mm_min_sd(first, speed));
    first = _mm_max_sd(first, speed);
  }
  if constexpr (kBooked) {
    of_velocity.put(*range.sums, 0);
    of_spin.put(*range.sums, 4);
  }
  return {_mm_cvtsd_f64(first), _mm_cvtsd_f64(second)};
}

FastestTwo avx2_motion(const GrainRange& range) {
  return range.sums ? motion_as<true>(range) : motion_as<false>(range);
}

}  // namespace

const Kernels kAvx2Kernels{PairVectors<Avx2>::run, avx2_motion};

}  // namespace triax::sim
#else
namespace triax::sim {
const Kernels kAvx2Kernels{};
}
#endif
