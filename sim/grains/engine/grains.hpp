// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The engine: steps a GrainState explicitly in time.
//
//   1. forces at the positions x_n, tangential forces grown by the velocities v_{n−1/2}
//   2. v_{n+1/2} = v_{n−1/2} + Δt (a − damping),  x_{n+1} = x_n + Δt v_{n+1/2};  spins alike
//   3. walls move by their drives
//   4. neighbours are renewed where they may be out of date
//
// The result has the same bits on any number of threads and with any instruction set: blocks are a
// function of the specimen, sums are made in fixed order, nothing is fused. A small specimen (some
// thousand grains) gains little from a second thread; independent specimens side by side gain more.
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>

#include "sim/grains/engine/blocks.hpp"
#include "sim/grains/engine/grain_ledger.hpp"
#include "sim/grains/engine/kernels.hpp"
#include "sim/grains/engine/team.hpp"
#include "sim/grains/state/grain_state.hpp"

namespace triax::sim {

class Grains {
 public:
  /// Throws std::invalid_argument if `set` is not available here or threads is not 1 to 64.
  explicit Grains(GrainState state, int threads = 1, InstructionSet set = best_instruction_set());

  const GrainState& state() const { return state_; }
  /// Goes on from another state (of any specimen): what a probe does with its copies.
  void restore(const GrainState& state);

  /// Advances n steps and returns how many were made: fewer if a grain went farther than the
  /// smallest radius in one step (the step is too long for the stiffness); the state is then the
  /// one after that step. After std::bad_alloc only restore() is of use.
  std::int64_t step(std::int64_t n);

  /// Keeps a ledger of energy and momentum (grain_ledger.hpp) from the next step on. The same bits.
  void keep_ledger();
  /// Until now; empty where none is kept or no step was made since. restore() begins a new one.
  std::optional<GrainLedger> ledger() const;

  /// Drives of all three axes. A stress target starts at what its axis carries now. Throws
  /// std::invalid_argument (walls.hpp) and changes nothing.
  void drive(const std::array<AxisDrive, 3>& drives);
  /// φ between grains, rad; pre-condition as ContactLaw.
  void set_friction_angle(double friction_angle);
  void set_damping(double damping);
  void set_time_step(double time_step_s);
  /// Margins for another regime (loose, or fast); sorts.
  void set_margin(const NeighbourMargin& margin);
  /// Takes all motion out of grains: those that float feel no force, and no damping stops them.
  void stop_motion();
  /// Velocity of the grain at `index` of state().grains, m/s.
  void set_velocity(std::size_t index, const std::array<double, 3>& velocity_m_per_s);

 private:
  void load_walls();
  void finish_step();

  GrainState state_;
  Kernels kernels_;
  Blocks blocks_;
  std::unique_ptr<Team> team_;
  double smallest_radius_ = 0;
  std::int64_t made_ = 0;
  bool stop_ = false;
  std::exception_ptr failure_;
  std::optional<LedgerBook> book_;
};

}  // namespace triax::sim
