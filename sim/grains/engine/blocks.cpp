// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/blocks.hpp"

#include <algorithm>

namespace triax::sim {
namespace {

/// A function of the specimen alone: its results must not depend on the machine.
std::int64_t block_count(std::size_t grains) {
  if (grains < 500) return 1;
  if (grains < 4000) return 2;
  return grains < 20000 ? 4 : 8;
}

constexpr std::int64_t kPairsTogether = 8;

}  // namespace

void Blocks::renew(const GrainState& state) {
  const NearPairs& near = state.neighbours.near;
  const auto pairs = static_cast<std::int64_t>(near.size());
  const auto grains = static_cast<std::int32_t>(state.grains.size());
  const std::int64_t count = block_count(state.grains.size());
  blocks_.resize(count);
  for (std::int64_t b = 0; b < count; ++b) {
    const auto share = [&](std::int64_t part) {
      return part == count ? pairs : pairs * part / count / kPairsTogether * kPairsTogether;
    };
    Block& block = blocks_[b];
    block.pairs_begin = share(b);
    block.pairs_end = share(b + 1);
    const std::int32_t from = block.pairs_begin < pairs ? near.i[block.pairs_begin] : grains;
    block.first = b == 0 ? 0 : from;
  }
  for (std::int64_t b = 0; b < count; ++b) {
    blocks_[b].end = b + 1 == count ? grains : blocks_[b + 1].first;
    place(blocks_[b], state);
  }
}

/// The grains that the block's pairs load, and its grains at the walls.
void Blocks::place(Block& block, const GrainState& state) {
  const Neighbours& n = state.neighbours;
  block.loaded_end = block.end;
  for (std::int64_t k = block.pairs_begin; k < block.pairs_end; ++k)
    block.loaded_end = std::max(block.loaded_end, n.near.j[k] + 1);
  block.loads.assign(block.loaded_end - block.first, GrainLoad{});
  for (int w = 0; w < 6; ++w) {
    const auto& at_wall = n.near_wall[w];
    const auto rank = [&](std::int32_t grain) {
      const auto place = std::lower_bound(at_wall.begin(), at_wall.end(), grain);
      return static_cast<std::int32_t>(place - at_wall.begin());
    };
    block.wall_begin[w] = rank(block.first);
    block.wall_end[w] = rank(block.end);
  }
}

void Blocks::load_walls(const GrainState& state, Block& block) {
  for (int w = 0; w < 6; ++w) {
    const int axis = w / 2;
    const double inwards = w % 2 == 0 ? 1 : -1;
    const double wall = w % 2 == 0 ? state.box.low_m[axis] : state.box.high_m[axis];
    double force = 0, stiffness = 0;
    for (std::int32_t k = block.wall_begin[w]; k < block.wall_end[w]; ++k) {
      const std::int32_t i = state.neighbours.near_wall[w][k];
      const Grain& g = state.grains[i];
      const double depth = g.radius - inwards * (g.position[axis] - wall);
      const double contact_stiffness = depth > 0 ? wall_stiffness(state.law, g.radius) : 0;
      const double push = contact_stiffness * depth;
      block.loads[i - block.first].force[axis] += inwards * push;
      force += push;
      stiffness += contact_stiffness;
    }
    block.wall_force[w] = force;
    block.wall_stiffness[w] = stiffness;
  }
}

void Blocks::load(GrainState& state, const Kernels& kernels, int block) {
  Block& b = blocks_[block];
  NearPairs& near = state.neighbours.near;
  PairRange range{};
  range.grains = state.grains.data();
  range.loads = b.loads.data();
  range.first_grain = b.first;
  range.begin = b.pairs_begin;
  range.end = b.pairs_end;
  range.i = near.i.data();
  range.j = near.j.data();
  range.tx = near.tangential_n[0].data();
  range.ty = near.tangential_n[1].data();
  range.tz = near.tangential_n[2].data();
  range.stiffness = near.stiffness_n_per_m.data();
  range.reach = near.reach_m.data();
  range.half_difference = near.half_difference_m.data();
  range.friction_coefficient = friction_coefficient(state.law);
  range.tangential_step = state.law.tangential_ratio * state.time_step_s;
  range.half_step = 0.5 * state.time_step_s;
  std::fill(b.loads.begin() + (b.end - b.first), b.loads.end(), GrainLoad{});
  b.friction_j = 0;
  if (booked_) range.friction_j = &b.friction_j;
  kernels.pairs(range);
  load_walls(state, b);
}

void Blocks::add_halos(int block) {
  Block& own = blocks_[block];
  for (int other = 0; other < block; ++other) {
    Block& before = blocks_[other];
    const std::int32_t end = std::min(before.loaded_end, own.end);
    for (std::int32_t i = own.first; i < end; ++i) {
      GrainLoad& sum = own.loads[i - own.first];
      const GrainLoad& halo = before.loads[i - before.first];
      for (int a = 0; a < 3; ++a) {
        sum.force[a] += halo.force[a];
        sum.moment[a] += halo.moment[a];
      }
    }
  }
}

void Blocks::move(GrainState& state, const Kernels& kernels, int block) {
  add_halos(block);
  Block& b = blocks_[block];
  GrainRange range{};
  range.grains = state.grains.data() + b.first;
  range.loads = b.loads.data();
  range.count = b.end - b.first;
  range.time_step = state.time_step_s;
  range.damping = state.law.damping;
  b.sums = {};
  if (booked_) range.sums = &b.sums;
  b.fastest = kernels.motion(range);
}

void Blocks::sum_walls(WallState& walls) const {
  walls.force_n.fill(0);
  walls.stiffness_n_per_m.fill(0);
  for (const Block& b : blocks_)
    for (int w = 0; w < 6; ++w) {
      walls.force_n[w] += b.wall_force[w];
      walls.stiffness_n_per_m[w] += b.wall_stiffness[w];
    }
}

double Blocks::friction_j() const {
  double sum = 0;
  for (const Block& b : blocks_) sum += b.friction_j;
  return sum;
}

MotionTotals Blocks::motion_totals() const {
  MotionTotals all;
  for (const Block& b : blocks_)
    for (const int c : {0, 1, 2, 4, 5, 6}) {
      all.kinetic += b.sums.kinetic[c];
      all.damping_before += b.sums.damping_before[c];
      all.damping_after += b.sums.damping_after[c];
      if (c > 2) continue;
      all.momentum[c] += b.sums.momentum[c];
      all.braked[c] -= b.sums.braked[c];
    }
  return all;
}

FastestTwo Blocks::fastest() const {
  FastestTwo all{0, 0};
  for (const Block& b : blocks_) {
    all.second = std::max({std::min(all.first, b.fastest.first), all.second, b.fastest.second});
    all.first = std::max(all.first, b.fastest.first);
  }
  return all;
}

}  // namespace triax::sim
