#include "sim/grains/kernels.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

namespace triax::sim {
namespace {

using V = __m256d;

/// Four vectors of x, y and z, one lane a pair.
struct Columns {
  V x, y, z;
};

Columns columns(V a, V b, V c, V d) {
  const V ab0 = _mm256_unpacklo_pd(a, b), ab1 = _mm256_unpackhi_pd(a, b),
          cd0 = _mm256_unpacklo_pd(c, d), cd1 = _mm256_unpackhi_pd(c, d);
  return {_mm256_permute2f128_pd(ab0, cd0, 0x20), _mm256_permute2f128_pd(ab1, cd1, 0x20),
          _mm256_permute2f128_pd(ab0, cd0, 0x31)};
}

V halves(const double* low, const double* high) {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(low)), _mm_load_pd(high), 1);
}

/// As columns(), of rows in memory.
Columns columns_at(const double* a, const double* b, const double* c, const double* d) {
  const V ac = halves(a, c), bd = halves(b, d);
  const V ac_z = halves(a + 2, c + 2), bd_z = halves(b + 2, d + 2);
  return {_mm256_unpacklo_pd(ac, bd), _mm256_unpackhi_pd(ac, bd), _mm256_unpacklo_pd(ac_z, bd_z)};
}

/// A row of four doubles, through the whole grain: `position` alone ends after three.
const double* row_of(const Grain* g, int row) {
  return reinterpret_cast<const double*>(g) + 4 * row;
}

/// Rows x, y, z, 0 of each pair.
void to_rows(const Columns& c, V rows[4]) {
  const V zero = _mm256_setzero_pd();
  const V xy0 = _mm256_unpacklo_pd(c.x, c.y), xy1 = _mm256_unpackhi_pd(c.x, c.y),
          z0 = _mm256_unpacklo_pd(c.z, zero), z1 = _mm256_unpackhi_pd(c.z, zero);
  rows[0] = _mm256_permute2f128_pd(xy0, z0, 0x20);
  rows[1] = _mm256_permute2f128_pd(xy1, z1, 0x20);
  rows[2] = _mm256_permute2f128_pd(xy0, z0, 0x31);
  rows[3] = _mm256_permute2f128_pd(xy1, z1, 0x31);
}

V dot(const Columns& a, const Columns& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
Columns cross(const Columns& a, const Columns& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Columns operator*(const Columns& a, V s) { return {a.x * s, a.y * s, a.z * s}; }
Columns operator+(const Columns& a, const Columns& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Columns operator-(const Columns& a, const Columns& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Columns operator&(const Columns& a, V mask) {
  return {_mm256_and_pd(a.x, mask), _mm256_and_pd(a.y, mask), _mm256_and_pd(a.z, mask)};
}

void store(const PairRange& r, std::int64_t k, const Columns& t) {
  _mm256_store_pd(r.tx + k, t.x);
  _mm256_store_pd(r.ty + k, t.y);
  _mm256_store_pd(r.tz + k, t.z);
}

void add_four(const PairRange& r, std::int64_t k) {
  const Grain *a[4], *b[4];
  for (int q = 0; q < 4; ++q) {
    a[q] = r.grains + r.i[k + q];
    b[q] = r.grains + r.j[k + q];
  }
  const auto difference = [&](int q, int row) {
    return _mm256_load_pd(row_of(b[q], row)) - _mm256_load_pd(row_of(a[q], row));
  };
  const Columns d = columns(difference(0, 0), difference(1, 0), difference(2, 0), difference(3, 0));
  const V square = dot(d, d), reach = _mm256_load_pd(r.reach + k);
  const V touch = _mm256_cmp_pd(square, reach * reach, _CMP_LT_OQ);
  if (_mm256_movemask_pd(touch) == 0) {
    const V zero = _mm256_setzero_pd();
    store(r, k, {zero, zero, zero});
    return;
  }
  const V distance = _mm256_sqrt_pd(square);
  const Columns n = d * (_mm256_set1_pd(1) / distance);
  const V arm_a = _mm256_set1_pd(0.5) * distance + _mm256_load_pd(r.half_difference + k);
  const V arm_b = distance - arm_a;
  alignas(32) double arms_a[4], arms_b[4];
  _mm256_store_pd(arms_a, arm_a);
  _mm256_store_pd(arms_b, arm_b);

  const Columns wa = columns_at(a[0]->spin, a[1]->spin, a[2]->spin, a[3]->spin);
  const Columns wb = columns_at(b[0]->spin, b[1]->spin, b[2]->spin, b[3]->spin);
  const Columns u =
      columns(difference(0, 1), difference(1, 1), difference(2, 1), difference(3, 1)) -
      cross(wa * arm_a + wb * arm_b, n);
  const Columns twist = n * (_mm256_set1_pd(r.half_step) * dot(wa + wb, n));
  const Columns h{_mm256_load_pd(r.tx + k), _mm256_load_pd(r.ty + k), _mm256_load_pd(r.tz + k)};
  const V stiffness = _mm256_load_pd(r.stiffness + k);
  Columns t = (h + cross(twist, h)) + u * (stiffness * _mm256_set1_pd(r.tangential_step));
  t = t - n * dot(t, n);

  V normal = stiffness * (reach - distance);
  const V limit = _mm256_set1_pd(r.friction_coefficient) * normal, size = dot(t, t);
  const V slides = _mm256_and_pd(_mm256_cmp_pd(size, limit * limit, _CMP_GT_OQ), touch);
  if (_mm256_movemask_pd(slides) != 0)
    t = t * _mm256_blendv_pd(_mm256_set1_pd(1), limit / _mm256_sqrt_pd(size), slides);
  t = t & touch;
  normal = _mm256_and_pd(normal, touch);
  store(r, k, t);

  V force[4], moment[4];
  to_rows(t - n * normal, force);
  to_rows(cross(n, t), moment);
  for (int q = 0; q < 4; ++q) {
    double* la = r.loads[r.i[k + q] - r.first_grain].force;
    double* lb = r.loads[r.j[k + q] - r.first_grain].force;
    _mm256_store_pd(la, _mm256_load_pd(la) + force[q]);
    _mm256_store_pd(la + 4, _mm256_load_pd(la + 4) + moment[q] * _mm256_broadcast_sd(arms_a + q));
    _mm256_store_pd(lb, _mm256_load_pd(lb) - force[q]);
    _mm256_store_pd(lb + 4, _mm256_load_pd(lb + 4) + moment[q] * _mm256_broadcast_sd(arms_b + q));
  }
}

void avx2_pairs(const PairRange& range) {
  PairRange rest = range;
  for (; rest.begin + 4 <= range.end; rest.begin += 4) add_four(range, rest.begin);
  portable_pairs(rest);
}

FastestTwo avx2_motion(const GrainRange& range) {
  const auto row = [](double x) { return _mm256_setr_pd(x, x, x, 0); };  // 1/m and 1/I stay
  const V step = row(range.time_step), half = row(0.5 * range.time_step);
  const V damping = row(range.damping), sign = _mm256_set1_pd(-0.0), zero = _mm256_setzero_pd();
  const auto next = [&](V v, V a) {
    const V brake = _mm256_andnot_pd(sign, damping * a);
    return v + step * (a - _mm256_or_pd(brake, _mm256_and_pd(v + half * a, sign)));
  };
  __m128d first = _mm_setzero_pd(), second = first;
  for (std::int64_t i = 0; i < range.count; ++i) {
    Grain& g = range.grains[i];
    GrainLoad& load = range.loads[i];
    const V v = next(_mm256_load_pd(g.velocity),
                     _mm256_load_pd(load.force) * _mm256_broadcast_sd(&g.inverse_mass));
    const V w = next(_mm256_load_pd(g.spin),
                     _mm256_load_pd(load.moment) * _mm256_broadcast_sd(&g.inverse_inertia));
    _mm256_store_pd(g.velocity, v);
    _mm256_store_pd(g.spin, w);
    _mm256_store_pd(g.position, _mm256_load_pd(g.position) + step * v);
    _mm256_store_pd(load.force, zero);
    _mm256_store_pd(load.moment, zero);
    const V squares = v * v;
    const __m128d xy = _mm256_castpd256_pd128(squares);
    const __m128d speed = _mm_add_sd(_mm_hadd_pd(xy, xy), _mm256_extractf128_pd(squares, 1));
    second = _mm_max_sd(second, _mm_min_sd(first, speed));
    first = _mm_max_sd(first, speed);
  }
  return {_mm_cvtsd_f64(first), _mm_cvtsd_f64(second)};
}

}  // namespace

const Kernels kAvx2Kernels{avx2_pairs, avx2_motion};

}  // namespace triax::sim
#else
namespace triax::sim {
const Kernels kAvx2Kernels{};
}
#endif
