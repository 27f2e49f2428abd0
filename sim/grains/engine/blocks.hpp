// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Work of one step in a fixed number of blocks, so that sums do not depend on the number of
// threads.
//
// Block b visits a range of the near pairs. As i < j and pairs ascend, it loads only grains from
// its own first one on: its own grains and some of the next blocks' (the halo). Each block has
// loads of its own; the owner of a grain adds the halos of the blocks before it, in their order.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/grains/engine/kernels.hpp"
#include "sim/grains/state/aligned_vector.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

/// MotionSums over all components and grains.
struct MotionTotals {
  double kinetic = 0, damping_before = 0, damping_after = 0;
  std::array<double, 3> momentum{}, braked{};  ///< of the velocities
};

class Blocks {
 public:
  explicit Blocks(const GrainState& state) { renew(state); }

  /// To be called whenever the near lists of the state are new.
  void renew(const GrainState& state);

  int count() const { return static_cast<int>(blocks_.size()); }

  /// From now on what a ledger needs is summed, too.
  void book() { booked_ = true; }

  /// Forces of the block's pairs and of the walls on its grains.
  void load(GrainState& state, const Kernels& kernels, int block);
  /// Moves the block's grains. Pre-condition: every block is loaded.
  void move(GrainState& state, const Kernels& kernels, int block);

  /// Sums over the blocks, in their order, of what load() found; sets force and stiffness.
  void sum_walls(WallState& walls) const;
  /// Sums over the blocks, in their order, of the last load() and of the last move(); booked.
  double friction_j() const;
  MotionTotals motion_totals() const;
  /// The two fastest of all grains at the last move().
  FastestTwo fastest() const;

 private:
  struct alignas(64) Block {
    std::int64_t pairs_begin = 0, pairs_end = 0;
    std::int32_t first = 0, end = 0;  ///< own grains
    std::int32_t loaded_end = 0;      ///< own and halo
    std::array<std::int32_t, 6> wall_begin{}, wall_end{};
    std::array<double, 6> wall_force{}, wall_stiffness{};
    FastestTwo fastest{};
    double friction_j = 0;
    MotionSums sums;
    /// Of grains first to loaded_end; own ones are 0 between steps. The halo is cleared by whoever
    /// loads the block, not by its readers: what only one thread writes stays in its cache.
    AlignedVector<GrainLoad> loads;
  };
  static void place(Block& block, const GrainState& state);
  static void load_walls(const GrainState& state, Block& block);
  void add_halos(int block);

  std::vector<Block> blocks_;
  bool booked_ = false;
};

}  // namespace triax::sim
