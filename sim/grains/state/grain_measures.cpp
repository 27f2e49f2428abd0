// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::sim {
namespace {

using Eigen::Vector3d;

/// A sliding force was put at the limit in the last step; positions restored from x − Δt v differ
/// from those it was put there by rounding only.
constexpr double kSlides = 1 - 1e-9;

Vector3d vector(const double* v) { return {v[0], v[1], v[2]}; }

Vector3d before(const GrainState& s, const Grain& g) {
  return vector(g.position) - s.time_step_s * vector(g.velocity);
}

void add_grain_contacts(const GrainState& s, std::vector<GrainContact>& contacts) {
  const NearPairs& near = s.neighbours.near;
  const double friction = friction_coefficient(s.law);
  for (std::size_t k = 0; k < near.size(); ++k) {
    GrainContact c;
    c.i = near.i[k];
    c.j = near.j[k];
    c.branch_m = before(s, s.grains[c.j]) - before(s, s.grains[c.i]);
    const double distance = c.branch_m.norm(), overlap = near.reach_m[k] - distance;
    if (!(overlap > 0)) continue;
    c.normal = c.branch_m / distance;
    c.normal_force_n = near.stiffness_n_per_m[k] * overlap;
    const Vector3d tangential(near.tangential_n[0][k], near.tangential_n[1][k],
                              near.tangential_n[2][k]);
    c.tangential_force_n = tangential.norm();
    c.force_n = tangential - c.normal_force_n * c.normal;
    c.slides = c.tangential_force_n >= kSlides * friction * c.normal_force_n;
    contacts.push_back(c);
  }
}

void add_wall_contacts(const GrainState& s, std::vector<GrainContact>& contacts) {
  for (int w = 0; w < 6; ++w) {
    const int axis = w / 2;
    const double outwards = w % 2 == 0 ? -1 : 1;
    const double travel =
        0.5 * std::expm1(s.walls.strain_rate_per_s[axis] * s.time_step_s) * s.box.length_m(axis);
    const double wall = w % 2 == 0 ? s.box.low_m[axis] - travel : s.box.high_m[axis] + travel;
    for (const std::int32_t i : s.neighbours.near_wall[w]) {
      const Grain& g = s.grains[i];
      const double gap = outwards * (wall - before(s, g)[axis]);
      if (!(gap < g.radius)) continue;
      GrainContact c;
      c.i = i;
      c.j = -1 - w;
      c.normal = outwards * Vector3d::Unit(axis);
      c.branch_m = gap * c.normal;
      c.normal_force_n = wall_stiffness(s.law, g.radius) * (g.radius - gap);
      c.force_n = -c.normal_force_n * c.normal;
      contacts.push_back(c);
    }
  }
}

bool outside(const GrainState& s, const Grain& g) {
  for (int a = 0; a < 3; ++a)
    if (!(g.position[a] >= s.box.low_m[a] && g.position[a] <= s.box.high_m[a])) return true;
  return false;
}

}  // namespace

std::vector<GrainContact> contacts_of(const GrainState& state) {
  std::vector<GrainContact> contacts;
  contacts.reserve(state.neighbours.near.size());
  add_grain_contacts(state, contacts);
  add_wall_contacts(state, contacts);
  return contacts;
}

GrainMeasures measure(const GrainState& state) {
  GrainMeasures m;
  m.stress_pa.setZero();
  const auto grains = static_cast<double>(state.grains.size());
  std::vector<Vector3d> resultant(state.grains.size(), Vector3d::Zero());
  std::vector<bool> touched(state.grains.size());
  const std::vector<GrainContact> contacts = contacts_of(state);
  double force_sum = 0;
  for (const GrainContact& c : contacts) {
    const bool at_wall = c.j < 0;
    resultant[c.i] += c.force_n;
    touched[c.i] = true;
    m.stress_pa -= c.force_n * c.branch_m.transpose();
    (at_wall ? m.wall_contacts : m.grain_contacts) += 1;
    if (at_wall) {
      const int axis = (-1 - c.j) / 2;
      m.wall_stress_pa[axis] += 0.5 * c.normal_force_n / state.box.area_m2(axis);
      continue;
    }
    resultant[c.j] -= c.force_n;
    touched[c.j] = true;
    m.sliding_contacts += c.slides;
    force_sum += c.force_n.norm();
  }
  m.stress_pa /= state.box.volume_m3();
  double resultant_sum = 0;
  for (const Vector3d& f : resultant) resultant_sum += f.norm();
  if (m.grain_contacts > 0)
    m.unbalanced = resultant_sum / grains / (force_sum / static_cast<double>(m.grain_contacts));
  m.coordination = static_cast<double>(2 * m.grain_contacts + m.wall_contacts) / grains;
  m.floating_grains = std::count(touched.begin(), touched.end(), false);
  m.grains_outside = std::count_if(state.grains.begin(), state.grains.end(),
                                   [&](const Grain& g) { return outside(state, g); });
  m.kinetic_energy_j = kinetic_energy(state);
  m.porosity = porosity(state);
  m.void_ratio = m.porosity / (1 - m.porosity);
  return m;
}

double kinetic_energy(const GrainState& state) {
  double sum = 0;
  for (const Grain& g : state.grains)
    sum += 0.5 * (vector(g.velocity).squaredNorm() / g.inverse_mass +
                  vector(g.spin).squaredNorm() / g.inverse_inertia);
  return sum;
}

double porosity(const GrainState& state) {
  double solid = 0;
  for (const Grain& g : state.grains)
    solid += 4 * std::numbers::pi / 3 * g.radius * g.radius * g.radius;
  return 1 - solid / state.box.volume_m3();
}

}  // namespace triax::sim
