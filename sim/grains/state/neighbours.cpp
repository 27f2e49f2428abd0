// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/grains/state/cells.hpp"

namespace triax::sim {
namespace {

struct Carried {
  std::int32_t i, j;
  std::array<double, 3> tangential_n;
};

double distance_squared(const Grain& a, const Grain& b) {
  const double x = b.position[0] - a.position[0], y = b.position[1] - a.position[1],
               z = b.position[2] - a.position[2];
  return x * x + y * y + z * z;
}

/// Gap between a grain and wall `w`.
double wall_gap(const GrainBox& box, int w, const Grain& g) {
  const int axis = w / 2;
  const double x = g.position[axis];
  return (w % 2 == 0 ? x - box.low_m[axis] : box.high_m[axis] - x) - g.radius;
}

/// Pairs that carry a tangential force, in the order of i, with room for the new indices.
std::vector<Carried> carried_pairs(const NearPairs& near) {
  std::vector<Carried> carried;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const std::array<double, 3> t{near.tangential_n[0][k], near.tangential_n[1][k],
                                  near.tangential_n[2][k]};
    if (t[0] != 0 || t[1] != 0 || t[2] != 0) carried.push_back({near.i[k], near.j[k], t});
  }
  return carried;
}

void renumber(std::vector<Carried>& carried, const std::vector<std::int32_t>& place) {
  for (Carried& c : carried) {
    c.i = place[c.i];
    c.j = place[c.j];
    if (c.i < c.j) continue;
    std::swap(c.i, c.j);
    for (double& t : c.tangential_n) t = -t;
  }
  std::sort(carried.begin(), carried.end(), [](const Carried& a, const Carried& b) {
    return std::pair(a.i, a.j) < std::pair(b.i, b.j);
  });
}

void clear(NearPairs& near, std::size_t room) {
  const auto empty = [room](auto& v) {
    v.clear();
    v.reserve(room);
  };
  empty(near.listed);
  empty(near.i);
  empty(near.j);
  for (auto& t : near.tangential_n) empty(t);
  empty(near.stiffness_n_per_m);
  empty(near.reach_m);
  empty(near.half_difference_m);
}

/// Appends the listed pair `l`.
void append(NearPairs& near, const GrainState& state, std::int32_t l,
            const std::array<double, 3>& tangential) {
  const std::int32_t i = state.neighbours.listed_i[l], j = state.neighbours.listed_j[l];
  const double ri = state.grains[i].radius, rj = state.grains[j].radius;
  near.listed.push_back(l);
  near.i.push_back(i);
  near.j.push_back(j);
  for (int a = 0; a < 3; ++a) near.tangential_n[a].push_back(tangential[a]);
  near.stiffness_n_per_m.push_back(normal_stiffness(state.law, ri, rj));
  near.reach_m.push_back(ri + rj);
  near.half_difference_m.push_back(0.5 * (ri - rj));
}

/// Fills `near` from the listed pairs; `force_of` gives the tangential force a listed pair carries
/// and is asked in ascending order.
template <class ForceOf>
void fill_near(const GrainState& state, NearPairs& near, ForceOf force_of) {
  const Neighbours& n = state.neighbours;
  clear(near, n.listed_i.size());
  for (std::size_t l = 0; l < n.listed_i.size(); ++l) {
    const Grain &a = state.grains[n.listed_i[l]], &b = state.grains[n.listed_j[l]];
    const double reach = a.radius + b.radius + state.margin.near_m;
    const std::array<double, 3> tangential = force_of(l);
    if (distance_squared(a, b) < reach * reach)
      append(near, state, static_cast<std::int32_t>(l), tangential);
  }
}

void choose_near_walls(GrainState& state) {
  Neighbours& n = state.neighbours;
  for (int w = 0; w < 6; ++w) {
    n.near_wall[w].clear();
    for (const std::int32_t i : n.listed_at_wall[w])
      if (wall_gap(state.box, w, state.grains[i]) < state.margin.near_m)
        n.near_wall[w].push_back(i);
  }
  n.travelled_m = 0;
}

void choose_near(GrainState& state) {
  // Its memory is used again: fresh pages would cost more than the choice.
  static thread_local NearPairs chosen;
  const NearPairs& before = state.neighbours.near;
  std::size_t k = 0;
  fill_near(state, chosen, [&](std::size_t l) {
    std::array<double, 3> t{};
    if (k < before.size() && static_cast<std::size_t>(before.listed[k]) == l) {
      for (int a = 0; a < 3; ++a) t[a] = before.tangential_n[a][k];
      ++k;
    }
    return t;
  });
  std::swap(state.neighbours.near, chosen);
  choose_near_walls(state);
}

/// By how much the two that moved farthest since the last sorting may have approached, m.
double approach_since_sorted(const GrainState& state) {
  const Neighbours& n = state.neighbours;
  double first = 0, second = 0;
  const auto take = [&](double moved) {
    second = std::max(second, std::min(first, moved));
    first = std::max(first, moved);
  };
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    double square = 0;
    for (int a = 0; a < 3; ++a) {
      const double d = state.grains[i].position[a] - n.sorted_at_m[i][a];
      square += d * d;
    }
    take(square);
  }
  first = std::sqrt(first);
  second = std::sqrt(second);
  for (int a = 0; a < 3; ++a) {
    take(std::abs(state.box.low_m[a] - n.box_when_sorted.low_m[a]));
    take(std::abs(state.box.high_m[a] - n.box_when_sorted.high_m[a]));
  }
  return first + second;
}

}  // namespace

NeighbourMargin neighbour_margin(double radius_m) { return {0.25 * radius_m, 0.015 * radius_m}; }

void sort_grains(GrainState& state) {
  Neighbours& n = state.neighbours;
  std::vector<Carried> carried = carried_pairs(n.near);
  const CellGrid cells(state);
  const std::vector<std::int32_t> place = cells.sort(state);
  renumber(carried, place);
  cells.list_pairs(state, state.margin.listed_m, n.listed_i, n.listed_j);

  auto next = carried.cbegin();
  NearPairs near = std::move(n.near);
  fill_near(state, near, [&](std::size_t l) {
    const std::pair here(n.listed_i[l], n.listed_j[l]);
    while (next != carried.cend() && std::pair(next->i, next->j) < here) ++next;
    const bool carries = next != carried.cend() && std::pair(next->i, next->j) == here;
    return carries ? next->tangential_n : std::array<double, 3>{};
  });
  n.near = std::move(near);

  n.sorted_at_m.resize(state.grains.size());
  for (std::size_t i = 0; i < state.grains.size(); ++i)
    std::copy_n(state.grains[i].position, 3, n.sorted_at_m[i].begin());
  for (int w = 0; w < 6; ++w) {
    n.listed_at_wall[w].clear();
    for (std::size_t i = 0; i < state.grains.size(); ++i)
      if (wall_gap(state.box, w, state.grains[i]) < state.margin.listed_m)
        n.listed_at_wall[w].push_back(static_cast<std::int32_t>(i));
  }
  n.box_when_sorted = state.box;
  ++state.sorts;
  choose_near_walls(state);
}

void renew_neighbours(GrainState& state) {
  if (approach_since_sorted(state) + state.margin.near_m < state.margin.listed_m)
    choose_near(state);
  else
    sort_grains(state);
}

}  // namespace triax::sim
