// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/grains/state/walls.hpp"

namespace triax::sim {
namespace {

/// Lengths of a specimen, m: with these no square, volume or quotient leaves the numbers.
constexpr double kSmallestLength = 1e-9, kLargestLength = 1e6;
/// Speeds, stresses, forces, stiffnesses, times.
constexpr double kLargestValue = 1e30;
/// Natural strain of the box in one step: a wall would jump.
constexpr double kLargestStrainStep = 0.01;
/// Grains farther apart than this many largest diameters are no neighbours.
constexpr double kLargestMargin = 4;
constexpr double kRounding = 1e-9;

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("grain state: ") + what);
}

bool within(double x, double low, double high) { return x >= low && x <= high; }
bool moderate(double x) { return std::abs(x) <= kLargestValue; }
bool moderate(const auto& values) {
  return std::all_of(std::begin(values), std::end(values), [](double x) { return moderate(x); });
}

bool near(double a, double b) { return std::abs(a - b) <= kRounding * std::abs(b); }

bool is_box(const GrainBox& box) {
  for (int a = 0; a < 3; ++a)
    if (!within(box.low_m[a], -kLargestLength, kLargestLength) ||
        !within(box.length_m(a), kSmallestLength, kLargestLength))
      return false;
  return true;
}

void check_settings(const GrainState& s) {
  check(s.law);
  require(s.law.reading <= StiffnessReading::literal, "no such reading of the stiffness");
  require(s.law.stiffness_over_diameter_pa <= kLargestValue &&
              s.law.tangential_ratio <= kLargestValue && s.law.density_kg_per_m3 <= kLargestValue,
          "a value of the contact law is too large");
  require(within(s.time_step_s, 1e-30, kLargestValue), "the time step must be above 0");
  require(moderate(s.time_s) && s.steps >= 0 && s.sorts >= 0, "time or steps are no such numbers");
  require(is_box(s.box) && is_box(s.neighbours.box_when_sorted),
          "the box must have lengths above 0");
  require(s.margin.near_m > 0 && s.margin.listed_m > s.margin.near_m,
          "margins of neighbours must be above 0, that of the longer list the larger");
  require(within(s.neighbours.travelled_m, 0, kLargestLength), "the way travelled is no length");
}

void check_walls(const GrainState& s) {
  const WallState& w = s.walls;
  for (const AxisDrive& d : w.drive)
    require(d.kind <= AxisDrive::Kind::follows, "no such drive of an axis");
  check(w.drive);
  require(moderate(w.stress_target_pa) && moderate(w.force_n) && moderate(w.stiffness_n_per_m),
          "a stress or force of the walls is not finite");
  for (const double stiffness : w.stiffness_n_per_m)
    require(stiffness >= 0, "the stiffness of a wall is below 0");
  const auto slow = [&](double rate) { return std::abs(rate) * s.time_step_s; };
  for (int a = 0; a < 3; ++a) {
    const AxisDrive& d = w.drive[a];
    require(moderate(d.stress_goal_pa) && d.stress_rate_pa_per_s <= kLargestValue &&
                std::abs(d.ratio) <= kLargestValue,
            "the goal of an axis is too large");
    const double servo = 2 * d.speed_limit_m_per_s / s.box.length_m(a);
    const AxisDrive& leader = w.drive[d.leader % 3];
    const double led = leader.kind == AxisDrive::Kind::strain_rate
                           ? leader.strain_rate_per_s
                           : 2 * leader.speed_limit_m_per_s / s.box.length_m(d.leader % 3);
    const double asked = d.kind == AxisDrive::Kind::strain_rate ? d.strain_rate_per_s
                         : d.kind == AxisDrive::Kind::stress    ? servo
                                                                : d.ratio * led;
    require(slow(w.strain_rate_per_s[a]) <= kLargestStrainStep &&
                slow(w.learned_rate_per_s[a]) <= kLargestStrainStep &&
                slow(asked) <= kLargestStrainStep,
            "a wall moves too far in one step");
  }
}

void check_grain(const GrainState& s, const Grain& g) {
  require(within(g.radius, kSmallestLength, kLargestLength), "a radius must be above 0");
  const double mass =
      s.law.density_kg_per_m3 * 4 / 3 * std::numbers::pi * g.radius * g.radius * g.radius;
  require(near(g.inverse_mass * mass, 1) &&
              near(g.inverse_inertia * 0.4 * mass * g.radius * g.radius, 1),
          "the mass of a grain is not that of its size");
  require(moderate(g.velocity) && moderate(g.spin), "a grain's motion is not finite");
  for (int a = 0; a < 3; ++a)
    require(within(g.position[a], s.box.low_m[a], s.box.high_m[a]), "a grain lies outside the box");
}

void check_grains(const GrainState& s) {
  const std::size_t count = s.grains.size();
  require(count > 0 && s.ids.size() == count && s.neighbours.sorted_at_m.size() == count,
          "lists of grains differ in length");
  double largest = 0;
  for (const Grain& g : s.grains) {
    check_grain(s, g);
    largest = std::max(largest, g.radius);
  }
  require(s.margin.listed_m <= kLargestMargin * 2 * largest,
          "the margin of neighbours is too large");
  for (const auto& place : s.neighbours.sorted_at_m)
    for (const double x : place)
      require(within(x, -2 * kLargestLength, 2 * kLargestLength), "a place is not finite");
  std::vector<bool> named(count);
  for (const std::int32_t id : s.ids) {
    require(id >= 0 && static_cast<std::size_t>(id) < count && !named[id],
            "ids of grains are out of range or twice there");
    named[id] = true;
  }
}

void check_listed(const GrainState& s) {
  const auto &i = s.neighbours.listed_i, &j = s.neighbours.listed_j;
  require(i.size() == j.size(), "lists of pairs differ in length");
  const auto count = static_cast<std::int64_t>(s.grains.size());
  for (std::size_t k = 0; k < i.size(); ++k) {
    require(i[k] >= 0 && i[k] < j[k] && j[k] < count, "a pair is of grains that are not there");
    require(k == 0 || std::pair(i[k - 1], j[k - 1]) < std::pair(i[k], j[k]),
            "pairs are out of order");
  }
}

void check_near(const GrainState& s) {
  const Neighbours& n = s.neighbours;
  const NearPairs& p = n.near;
  const std::size_t pairs = p.size();
  require(p.j.size() == pairs && p.listed.size() == pairs && p.stiffness_n_per_m.size() == pairs &&
              p.reach_m.size() == pairs && p.half_difference_m.size() == pairs,
          "lists of near pairs differ in length");
  for (const auto& t : p.tangential_n)
    require(t.size() == pairs && moderate(t), "a tangential force is not finite");
  for (std::size_t k = 0; k < pairs; ++k) {
    const std::int32_t l = p.listed[k];
    require(l >= 0 && static_cast<std::size_t>(l) < n.listed_i.size() &&
                (k == 0 || p.listed[k - 1] < l) && n.listed_i[l] == p.i[k] &&
                n.listed_j[l] == p.j[k],
            "a near pair is not the listed one");
    const double ri = s.grains[p.i[k]].radius, rj = s.grains[p.j[k]].radius;
    require(near(p.reach_m[k], ri + rj) &&
                near(p.stiffness_n_per_m[k], normal_stiffness(s.law, ri, rj)) &&
                std::abs(p.half_difference_m[k] - 0.5 * (ri - rj)) <= kRounding * (ri + rj),
            "a pair is not one of its grains' sizes");
  }
}

bool ascending(const std::vector<std::int32_t>& list) {
  return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end();
}

void check_at_walls(const GrainState& s) {
  const auto count = static_cast<std::int64_t>(s.grains.size());
  for (int w = 0; w < 6; ++w) {
    const auto &listed = s.neighbours.listed_at_wall[w], &near_wall = s.neighbours.near_wall[w];
    require(ascending(listed) && ascending(near_wall), "grains at a wall are out of order");
    require(listed.empty() || (listed.front() >= 0 && listed.back() < count),
            "a grain at a wall is not there");
    require(std::includes(listed.begin(), listed.end(), near_wall.begin(), near_wall.end()),
            "a grain near a wall is not listed there");
  }
}

}  // namespace

void check(const GrainState& state) {
  check_settings(state);
  check_walls(state);
  check_grains(state);
  check_listed(state);
  check_near(state);
  check_at_walls(state);
}

}  // namespace triax::sim
