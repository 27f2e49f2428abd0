// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/kernels.hpp"

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#include <immintrin.h>

#include "sim/grains/engine/pair_vectors.hpp"

namespace triax::sim {
namespace {

/// Rows of eight pairs, two in a vector: the processor crosses halves of a vector slowly.
struct TwoRows {
  __m512d at02, at13, at46, at57;
};

struct Avx512 {
  using V = __m512d;
  using Mask = __mmask8;
  static constexpr int kLanes = 8;

  static V load(const double* p) { return _mm512_load_pd(p); }
  static void store(double* p, V v) { _mm512_store_pd(p, v); }
  static V every(double x) { return _mm512_set1_pd(x); }
  static V root(V v) { return _mm512_sqrt_pd(v); }
  static Mask less(V a, V b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
  static Mask both(Mask m, Mask n) { return m & n; }
  static V keep(Mask m, V v) { return _mm512_maskz_mov_pd(m, v); }
  static V pick(Mask m, V a, V b) { return _mm512_mask_mov_pd(b, m, a); }
  static bool any(V v) { return _mm512_cmp_pd_mask(v, _mm512_setzero_pd(), _CMP_NEQ_UQ) != 0; }

  static TwoRows rows(const Grain* const g[kLanes], int row) {
    const auto two = [&](int q) {
      const double *low = row_of(g[q], row), *high = row_of(g[q + 2], row);
      return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(low)), _mm256_load_pd(high),
                                1);
    };
    return {two(0), two(1), two(4), two(5)};
  }
  static Columns<Avx512> columns(const TwoRows& r) {
    const V xz0 = _mm512_unpacklo_pd(r.at02, r.at13), xz4 = _mm512_unpacklo_pd(r.at46, r.at57);
    const V y0 = _mm512_unpackhi_pd(r.at02, r.at13), y4 = _mm512_unpackhi_pd(r.at46, r.at57);
    return {_mm512_shuffle_f64x2(xz0, xz4, 0x88), _mm512_shuffle_f64x2(y0, y4, 0x88),
            _mm512_shuffle_f64x2(xz0, xz4, 0xDD)};
  }
  static Columns<Avx512> columns(const Grain* const g[kLanes], int row) {
    return columns(rows(g, row));
  }
  static Columns<Avx512> columns_between(const Grain* const from[kLanes],
                                         const Grain* const to[kLanes], int row) {
    const TwoRows a = rows(from, row), b = rows(to, row);
    return columns({b.at02 - a.at02, b.at13 - a.at13, b.at46 - a.at46, b.at57 - a.at57});
  }

  /// Rows x, y, z, 0.
  static TwoRows to_rows(const Columns<Avx512>& c) {
    const V even = _mm512_unpacklo_pd(c.x, c.y), odd = _mm512_unpackhi_pd(c.x, c.y);
    const auto two = [&](V xy, int first, int z) {
      const __m512i from =
          _mm512_setr_epi64(first, first + 1, 8 + z, 0, first + 2, first + 3, 10 + z, 0);
      return _mm512_maskz_permutex2var_pd(0x77, xy, from, c.z);
    };
    return {two(even, 0, 0), two(odd, 0, 1), two(even, 4, 4), two(odd, 4, 5)};
  }
  /// A whole GrainLoad for each pair.
  static void to_loads(const TwoRows& force, const TwoRows& moment, V loads[kLanes]) {
    const auto two = [&](V f, V m, int q) {
      loads[q] = _mm512_insertf64x4(f, _mm512_castpd512_pd256(m), 1);
      loads[q + 2] = _mm512_shuffle_f64x2(f, m, 0xEE);
    };
    two(force.at02, moment.at02, 0);
    two(force.at13, moment.at13, 1);
    two(force.at46, moment.at46, 4);
    two(force.at57, moment.at57, 5);
  }
  static void add_loads(const PairRange& r, std::int64_t k, const Columns<Avx512>& force,
                        const Columns<Avx512>& moment, V arm_a, V arm_b) {
    const TwoRows rows = to_rows(force);
    V plus[kLanes], minus[kLanes];
    to_loads(rows, to_rows(moment * arm_a), plus);
    to_loads(rows, to_rows(moment * -arm_b), minus);
    for (int q = 0; q < kLanes; ++q) {
      double* on_a = r.loads[r.i[k + q] - r.first_grain].force;
      double* on_b = r.loads[r.j[k + q] - r.first_grain].force;
      store(on_a, load(on_a) + plus[q]);
      store(on_b, load(on_b) - minus[q]);
    }
  }
};

struct AllSums {
  __m512d kinetic = _mm512_setzero_pd(), before = kinetic, after = kinetic, momentum = kinetic,
          braked = kinetic;

  void add(__m512d v, __m512d tried, __m512d next, __m512d inverse) {
    const __m512d inertia = _mm512_set1_pd(1) / inverse, half = _mm512_set1_pd(0.5);
    const __m512d taken = inertia * (tried - next);
    kinetic = kinetic + half * inertia * v * next;
    before = before + half * taken * v;
    after = after + half * taken * next;
    momentum = momentum + inertia * next;
    braked = braked + taken;
  }
  void put(MotionSums& sums) const {
    _mm512_storeu_pd(sums.kinetic, kinetic);
    _mm512_storeu_pd(sums.damping_before, before);
    _mm512_storeu_pd(sums.damping_after, after);
    _mm512_storeu_pd(sums.momentum, momentum);
    _mm512_storeu_pd(sums.braked, braked);
  }
};

template <bool kBooked>
FastestTwo motion_as(const GrainRange& range) {
  const auto row = [](double x) {
    return _mm512_setr_pd(x, x, x, 0, x, x, x, 0);
  };  // 1/m, 1/I stay
  const __m512d step = row(range.time_step), half = row(0.5 * range.time_step);
  const __m512d damping = row(range.damping), sign = _mm512_set1_pd(-0.0),
                zero = _mm512_setzero_pd();
  __m128d first = _mm_setzero_pd(), second = first;
  AllSums sums;
  Grain* grains = range.grains;
  GrainLoad* loads = range.loads;
  const std::int64_t count = range.count;
  for (std::int64_t i = 0; i < count; ++i) {
    Grain& g = grains[i];
    GrainLoad& load = loads[i];
    const __m512d v = _mm512_loadu_pd(g.velocity);  // and the spin
    const __m512d inverse = _mm512_permutex_pd(v, 0xFF);
    const __m512d a = _mm512_load_pd(load.force) * inverse;
    const __m512d brake = _mm512_andnot_pd(sign, damping * a);
    const __m512d next = v + step * (a - _mm512_or_pd(brake, _mm512_and_pd(v + half * a, sign)));
    if constexpr (kBooked) sums.add(v, v + step * a, next, inverse);
    _mm512_storeu_pd(g.velocity, next);
    _mm512_store_pd(load.force, zero);
    const __m256d velocity = _mm512_castpd512_pd256(next);
    _mm256_store_pd(g.position,
                    _mm256_load_pd(g.position) + _mm512_castpd512_pd256(step) * velocity);
    const __m256d squares = velocity * velocity;
    const __m128d xy = _mm256_castpd256_pd128(squares);
    const __m128d speed =
        _mm_add_sd(_mm_add_sd(xy, _mm_unpackhi_pd(xy, xy)), _mm256_extractf128_pd(squares, 1));
    second = _mm_max_sd(second, _mm_min_sd(first, speed));
    first = _mm_max_sd(first, speed);
  }
  if constexpr (kBooked) sums.put(*range.sums);
  return {_mm_cvtsd_f64(first), _mm_cvtsd_f64(second)};
}

FastestTwo avx512_motion(const GrainRange& range) {
  return range.sums ? motion_as<true>(range) : motion_as<false>(range);
}

}  // namespace

const Kernels kAvx512Kernels{PairVectors<Avx512>::run, avx512_motion};

}  // namespace triax::sim
#else
namespace triax::sim {
const Kernels kAvx512Kernels{};
}
#endif
