// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "sim/grains/engine/kernels.hpp"

namespace triax::sim {
namespace {

double smaller(double a, double b) { return a < b ? a : b; }
double larger(double a, double b) { return a > b ? a : b; }

/// Mean of the force before and after, times the slip (T_tried − T_after)/k_t.
void book_sliding(const PairRange& r, std::int64_t k, const double (&before)[3],
                  const double (&tried)[3], const double (&after)[3]) {
  const double stiffness = r.stiffness[k] * r.tangential_step / (2 * r.half_step);
  double sum = 0;
  for (int a = 0; a < 3; ++a) sum += 0.5 * (before[a] + after[a]) * (tried[a] - after[a]);
  if (sum != 0) *r.friction_j += sum / stiffness;
}

void add_pair(const PairRange& r, std::int64_t k) {
  const Grain &a = r.grains[r.i[k]], &b = r.grains[r.j[k]];
  const double dx = b.position[0] - a.position[0], dy = b.position[1] - a.position[1],
               dz = b.position[2] - a.position[2];
  const double square = (dx * dx + dy * dy) + dz * dz, reach = r.reach[k];
  if (!(square < reach * reach)) {
    if (r.friction_j) {
      const double last[3] = {r.tx[k], r.ty[k], r.tz[k]};
      book_sliding(r, k, last, last, {0, 0, 0});
    }
    r.tx[k] = r.ty[k] = r.tz[k] = 0;
    return;
  }
  const double distance = std::sqrt(square), inverse = 1 / distance;
  const double nx = dx * inverse, ny = dy * inverse, nz = dz * inverse;
  const double arm_a = 0.5 * distance + r.half_difference[k], arm_b = distance - arm_a;

  const double *wa = a.spin, *wb = b.spin;
  const double ox = wa[0] * arm_a + wb[0] * arm_b, oy = wa[1] * arm_a + wb[1] * arm_b,
               oz = wa[2] * arm_a + wb[2] * arm_b;
  const double ux = (b.velocity[0] - a.velocity[0]) - (oy * nz - oz * ny),
               uy = (b.velocity[1] - a.velocity[1]) - (oz * nx - ox * nz),
               uz = (b.velocity[2] - a.velocity[2]) - (ox * ny - oy * nx);

  // The frame turns about the normal by the mean spin; its tilt is followed by projection.
  const double twist =
      r.half_step * (((wa[0] + wb[0]) * nx + (wa[1] + wb[1]) * ny) + (wa[2] + wb[2]) * nz);
  const double qx = twist * nx, qy = twist * ny, qz = twist * nz;
  const double hx = r.tx[k], hy = r.ty[k], hz = r.tz[k];
  const double stiffness = r.stiffness[k], growth = stiffness * r.tangential_step;
  double tx = (hx + (qy * hz - qz * hy)) + growth * ux,
         ty = (hy + (qz * hx - qx * hz)) + growth * uy,
         tz = (hz + (qx * hy - qy * hx)) + growth * uz;
  const double along = (tx * nx + ty * ny) + tz * nz;
  tx = tx - along * nx;
  ty = ty - along * ny;
  tz = tz - along * nz;

  const double normal = stiffness * (reach - distance);
  const double limit = r.friction_coefficient * normal, size = (tx * tx + ty * ty) + tz * tz;
  if (size > limit * limit) {
    const double scale = limit / std::sqrt(size);
    const double tried[3] = {tx, ty, tz};
    tx = tx * scale;
    ty = ty * scale;
    tz = tz * scale;
    if (r.friction_j) book_sliding(r, k, {hx, hy, hz}, tried, {tx, ty, tz});
  }
  r.tx[k] = tx;
  r.ty[k] = ty;
  r.tz[k] = tz;

  const double mx = ny * tz - nz * ty, my = nz * tx - nx * tz, mz = nx * ty - ny * tx;
  const double fx = tx - normal * nx, fy = ty - normal * ny, fz = tz - normal * nz;
  GrainLoad &la = r.loads[r.i[k] - r.first_grain], &lb = r.loads[r.j[k] - r.first_grain];
  la.force[0] += fx;
  la.force[1] += fy;
  la.force[2] += fz;
  la.moment[0] += mx * arm_a;
  la.moment[1] += my * arm_a;
  la.moment[2] += mz * arm_a;
  lb.force[0] -= fx;
  lb.force[1] -= fy;
  lb.force[2] -= fz;
  lb.moment[0] += mx * arm_b;
  lb.moment[1] += my * arm_b;
  lb.moment[2] += mz * arm_b;
}

/// v + Δt (a − α|a| sign(v + Δt/2 a))
double next_velocity(double v, double a, const GrainRange& r) {
  const double middle = v + (0.5 * r.time_step) * a;
  return v + r.time_step * (a - std::copysign(r.damping * std::abs(a), middle));
}

/// Of component `c` before it is moved; `inertia` is a mass or a moment of inertia.
void book(double v, double a, double inertia, const GrainRange& r, int c) {
  MotionSums& sums = *r.sums;
  const double next = next_velocity(v, a, r);
  const double taken = inertia * ((v + r.time_step * a) - next);  // of momentum, by damping
  sums.kinetic[c] += 0.5 * inertia * v * next;
  sums.damping_before[c] += 0.5 * taken * v;
  sums.damping_after[c] += 0.5 * taken * next;
  sums.momentum[c] += inertia * next;
  sums.braked[c] += taken;
}

void book(const Grain& g, const GrainLoad& load, const GrainRange& r) {
  for (int a = 0; a < 3; ++a) {
    book(g.velocity[a], load.force[a] * g.inverse_mass, 1 / g.inverse_mass, r, a);
    book(g.spin[a], load.moment[a] * g.inverse_inertia, 1 / g.inverse_inertia, r, 4 + a);
  }
}

}  // namespace

void portable_pairs(const PairRange& range) {
  for (std::int64_t k = range.begin; k < range.end; ++k) add_pair(range, k);
}

FastestTwo portable_motion(const GrainRange& range) {
  FastestTwo fastest{0, 0};
  for (std::int64_t i = 0; i < range.count; ++i) {
    Grain& g = range.grains[i];
    GrainLoad& load = range.loads[i];
    if (range.sums) book(g, load, range);
    for (int a = 0; a < 3; ++a) {
      g.velocity[a] = next_velocity(g.velocity[a], load.force[a] * g.inverse_mass, range);
      g.spin[a] = next_velocity(g.spin[a], load.moment[a] * g.inverse_inertia, range);
      g.position[a] = g.position[a] + range.time_step * g.velocity[a];
    }
    load = GrainLoad{};
    const double* v = g.velocity;
    const double speed = (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2];
    fastest.second = larger(fastest.second, smaller(fastest.first, speed));
    fastest.first = larger(fastest.first, speed);
  }
  return fastest;
}

const Kernels kPortableKernels{portable_pairs, portable_motion};

}  // namespace triax::sim
