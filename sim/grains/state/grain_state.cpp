// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "sim/grains/state/critical_time_step.hpp"
#include "sim/grains/state/neighbours.hpp"

namespace triax::sim {
namespace {

constexpr std::size_t kMostGrains = 1U << 30U;

void check_sphere(const Sphere& sphere, const GrainBox& box, std::size_t index) {
  const std::string name = "sphere " + std::to_string(index);
  if (!(sphere.radius_m > 0 && std::isfinite(sphere.radius_m)))
    throw std::invalid_argument(name + ": radius must be above 0");
  for (int a = 0; a < 3; ++a)
    if (!(sphere.centre_m[a] >= box.low_m[a] && sphere.centre_m[a] <= box.high_m[a]))
      throw std::invalid_argument(name + ": centre lies outside the box");
}

/// Two centres in one place have no direction to part in.
void check_centres(const GrainState& state) {
  const Neighbours& n = state.neighbours;
  for (std::size_t k = 0; k < n.near.size(); ++k) {
    const Grain &a = state.grains[n.near.i[k]], &b = state.grains[n.near.j[k]];
    if (std::equal(a.position, a.position + 3, b.position))
      throw std::invalid_argument("spheres " + std::to_string(state.ids[n.near.i[k]]) + " and " +
                                  std::to_string(state.ids[n.near.j[k]]) + " have one centre");
  }
}

Grain grain_of(const Sphere& sphere, double density) {
  const double r = sphere.radius_m, mass = density * 4 / 3 * std::numbers::pi * r * r * r;
  Grain g{};
  std::copy(sphere.centre_m.begin(), sphere.centre_m.end(), g.position);
  g.radius = r;
  g.inverse_mass = 1 / mass;
  g.inverse_inertia = 1 / (0.4 * mass * r * r);
  return g;
}

}  // namespace

GrainState make_grain_state(const std::vector<Sphere>& spheres, const GrainBox& box,
                            const ContactLaw& law, double time_step_s) {
  check(law);
  if (spheres.empty() || spheres.size() > kMostGrains)
    throw std::invalid_argument("a specimen has 1 to 2^30 grains");
  for (int a = 0; a < 3; ++a)
    if (!(box.length_m(a) > 0 && std::isfinite(box.length_m(a))))
      throw std::invalid_argument("the box must have a length above 0 along every axis");

  GrainState state;
  state.law = law;
  state.box = box;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    check_sphere(spheres[i], box, i);
    smallest = std::min(smallest, spheres[i].radius_m);
    state.grains.push_back(grain_of(spheres[i], law.density_kg_per_m3));
    state.ids.push_back(static_cast<std::int32_t>(i));
  }
  state.margin = neighbour_margin(smallest);
  sort_grains(state);
  check_centres(state);
  state.time_step_s = time_step_s > 0 ? time_step_s : usual_time_step(state);
  return state;
}

std::vector<Sphere> spheres_of(const GrainState& state) {
  std::vector<Sphere> spheres(state.grains.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    Sphere& s = spheres[state.ids[i]];
    std::copy_n(state.grains[i].position, 3, s.centre_m.begin());
    s.radius_m = state.grains[i].radius;
  }
  return spheres;
}

}  // namespace triax::sim
