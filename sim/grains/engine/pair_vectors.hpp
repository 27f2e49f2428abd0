// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The loop over pairs for vectors of any width, one lane a pair. `Set` is an instruction set:
//
//   V, Mask, kLanes   vector of doubles with its operators + − · /, comparison of two, lanes
//   load(p), store(p, v), every(x), root(v)
//   less(a, b), both(m, n)       masks
//   keep(m, v), pick(m, a, b)    v or 0; a or b
//   any(v)                       whether a lane is not 0
//   columns(grains, row), columns_between(from, to, row)
//                                x, y and z of a row (0 position, 1 velocity, 2 spin) of kLanes
//                                grains
//   add_loads(range, k, force, moment, arm_a, arm_b)
//                                pair by pair, of the pairs from k on
//
// It must have internal linkage: then all that is made of it here has, and stays in the one source
// that is compiled for that instruction set.
#include <cstdint>

#include "sim/grains/engine/kernels.hpp"

namespace triax::sim {

/// A row of four doubles, through the whole grain: `position` alone ends after three. Internal in
/// every source, as all here.
static inline const double* row_of(const Grain* g, int row) {
  return reinterpret_cast<const double*>(g) + 4 * row;
}

template <class Set>
struct Columns {
  using V = typename Set::V;
  V x, y, z;

  friend Columns operator+(const Columns& a, const Columns& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Columns operator-(const Columns& a, const Columns& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Columns operator*(const Columns& a, V s) { return {a.x * s, a.y * s, a.z * s}; }
  friend V dot(const Columns& a, const Columns& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  friend Columns cross(const Columns& a, const Columns& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// Three passes over a few vectors of pairs: a root and a quotient take so long that what waits for
/// them would fill the processor and keep it from starting on the next.
template <class Set>
class PairVectors {
 public:
  static void run(const PairRange& range) {
    range.friction_j ? run_as<true>(range) : run_as<false>(range);
  }

 private:
  using V = typename Set::V;
  using Vectors = Columns<Set>;
  static constexpr std::int64_t kLanes = Set::kLanes, kTogether = 8;

  struct Pairs {
    Vectors n, u;  ///< normal, velocity of j at the contact less that of i
    V distance, twist, normal_force;
    typename Set::Mask touch;
  };

  template <bool kBooked>
  static void run_as(const PairRange& range) {
    const PairRange r = range;  // of which the compiler knows that no store changes it
    Pairs some[kTogether];
    std::int64_t k = r.begin;
    while (k + kLanes <= r.end) {
      const std::int64_t left = (r.end - k) / kLanes, count = left < kTogether ? left : kTogether;
      for (std::int64_t s = 0; s < count; ++s) look_at(r, k + s * kLanes, some[s]);
      for (std::int64_t s = 0; s < count; ++s) grow<kBooked>(r, k + s * kLanes, some[s]);
      for (std::int64_t s = 0; s < count; ++s) load(r, k + s * kLanes, some[s]);
      k += count * kLanes;
    }
    PairRange rest = r;
    rest.begin = k;
    portable_pairs(rest);
  }

  static V arm(const PairRange& r, std::int64_t k, V distance) {
    return Set::every(0.5) * distance + Set::load(r.half_difference + k);
  }
  static Vectors tangential(const PairRange& r, std::int64_t k) {
    return {Set::load(r.tx + k), Set::load(r.ty + k), Set::load(r.tz + k)};
  }

  [[gnu::always_inline]] static void look_at(const PairRange& r, std::int64_t k, Pairs& p) {
    const Grain *a[kLanes], *b[kLanes];
    for (int q = 0; q < kLanes; ++q) {
      a[q] = r.grains + r.i[k + q];
      b[q] = r.grains + r.j[k + q];
    }
    const Vectors d = Set::columns_between(a, b, 0), v = Set::columns_between(a, b, 1);
    const Vectors wa = Set::columns(a, 2), wb = Set::columns(b, 2);
    const V square = dot(d, d), reach = Set::load(r.reach + k);
    p.touch = Set::less(square, reach * reach);
    p.distance = Set::root(square);
    p.n = d * (Set::every(1) / p.distance);
    const V arm_a = arm(r, k, p.distance), arm_b = p.distance - arm_a;
    p.u = v - cross(wa * arm_a + wb * arm_b, p.n);
    p.twist = Set::every(r.half_step) * dot(wa + wb, p.n);
  }

  template <bool kBooked>
  [[gnu::always_inline]] static void grow(const PairRange& r, std::int64_t k, Pairs& p) {
    const Vectors h = tangential(r, k), n = p.n;
    const V stiffness = Set::load(r.stiffness + k), reach = Set::load(r.reach + k);
    Vectors t = (h + cross(n * p.twist, h)) + p.u * (stiffness * Set::every(r.tangential_step));
    t = t - n * dot(t, n);
    p.normal_force = Set::keep(p.touch, stiffness * (reach - p.distance));
    const V limit = Set::every(r.friction_coefficient) * p.normal_force, size = dot(t, t);
    const auto slides = Set::both(Set::less(limit * limit, size), p.touch);
    const Vectors tried = t;
    t = t * Set::pick(slides, limit / Set::root(size), Set::every(1));
    if constexpr (kBooked) {
      const auto kept = [&](V a) { return Set::keep(p.touch, a); };
      const auto asked = [&](V a, V b) { return Set::pick(p.touch, a, b); };
      book_sliding(r, k, h, {asked(tried.x, h.x), asked(tried.y, h.y), asked(tried.z, h.z)},
                   {kept(t.x), kept(t.y), kept(t.z)});
    }
    Set::store(r.tx + k, Set::keep(p.touch, t.x));
    Set::store(r.ty + k, Set::keep(p.touch, t.y));
    Set::store(r.tz + k, Set::keep(p.touch, t.z));
  }

  /// As the portable version does: a pair that opens asked for what it had, and a pair that neither
  /// slid nor opened took nothing.
  static void book_sliding(const PairRange& r, std::int64_t k, const Vectors& before,
                           const Vectors& tried, const Vectors& after) {
    const V half = Set::every(0.5);
    const auto part = [&](V b, V t, V a) { return (half * (b + a)) * (t - a); };
    const V sum = (part(before.x, tried.x, after.x) + part(before.y, tried.y, after.y)) +
                  part(before.z, tried.z, after.z);
    if (!Set::any(sum)) return;
    alignas(64) double taken[kLanes];
    const V stiffness =
        Set::load(r.stiffness + k) * Set::every(r.tangential_step) / Set::every(2 * r.half_step);
    Set::store(taken, sum / stiffness);
    for (const double one : taken)
      if (one != 0) *r.friction_j += one;
  }

  [[gnu::always_inline]] static void load(const PairRange& r, std::int64_t k, const Pairs& p) {
    const Vectors t = tangential(r, k);
    const V arm_a = arm(r, k, p.distance);
    Set::add_loads(r, k, t - p.n * p.normal_force, cross(p.n, t), arm_a, p.distance - arm_a);
  }
};

}  // namespace triax::sim
