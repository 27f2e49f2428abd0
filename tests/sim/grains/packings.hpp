// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small arrangements of spheres for tests.
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "sim/grains/engine/grains.hpp"
#include "sim/grains/state/grain_bytes.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim::test {

inline ContactLaw undamped(double friction_angle = 0.6) {
  ContactLaw law;
  law.friction_angle = friction_angle;
  law.damping = 0;
  return law;
}

/// A cube of 1 m around the origin: walls that nothing reaches.
inline GrainBox far_walls() { return {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}; }

/// Two spheres on the x axis, the first at the origin.
inline GrainState pair_of(double r1, double r2, double overlap, const ContactLaw& law,
                          double time_step = 0) {
  return make_grain_state({{{0, 0, 0}, r1}, {{r1 + r2 - overlap, 0, 0}, r2}}, far_walls(), law,
                          time_step);
}

/// side³ spheres of 1 to 1.3 mm on a disturbed lattice, so close that most touch, in a box that
/// touches the outer ones.
inline GrainState lattice(int side, const ContactLaw& law = {}, double spacing = 2.2e-3,
                          unsigned seed = 1) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  std::vector<Sphere> spheres;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        Sphere s;
        const int at[3] = {x, y, z};
        for (int a = 0; a < 3; ++a)
          s.centre_m[a] = (at[a] + 0.5) * spacing + uniform(-0.05e-3, 0.05e-3);
        s.radius_m = uniform(1e-3, 1.3e-3);
        spheres.push_back(s);
      }
  const double length = side * spacing;
  return make_grain_state(spheres, {{0, 0, 0}, {length, length, length}}, law, 1e-6);
}

/// The grain that was described as number `id`.
inline const Grain& grain(const GrainState& state, int id) {
  for (std::size_t i = 0; i < state.ids.size(); ++i)
    if (state.ids[i] == id) return state.grains[i];
  return state.grains.at(state.ids.size());
}
inline Grain& grain(GrainState& state, int id) {
  return const_cast<Grain&>(grain(static_cast<const GrainState&>(state), id));
}

/// Random velocities and spins.
inline void shake(GrainState& state, double speed, unsigned seed = 2) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11U) * 0x1p-52 - 1; };
  for (Grain& g : state.grains)
    for (int a = 0; a < 3; ++a) {
      g.velocity[a] = speed * uniform();
      g.spin[a] = speed / g.radius * uniform();
    }
}

inline bool same_bits(const GrainState& a, const GrainState& b) {
  return save_grains(a) == save_grains(b);
}

inline double mass(const Grain& g) { return 1 / g.inverse_mass; }

}  // namespace triax::sim::test
