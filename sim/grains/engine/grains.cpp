// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/engine/grains.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "sim/grains/state/neighbours.hpp"
#include "sim/grains/state/walls.hpp"

namespace triax::sim {
namespace {

constexpr int kMostThreads = 64;
/// A bound of distances must stay one under rounding.
constexpr double kRoundingUp = 1 + 1e-9;

double smallest_radius(const GrainState& state) {
  const auto smaller = [](const Grain& a, const Grain& b) { return a.radius < b.radius; };
  return std::min_element(state.grains.begin(), state.grains.end(), smaller)->radius;
}

Kernels kernels_or_throw(InstructionSet set) {
  if (!available(set)) throw std::invalid_argument("instruction set is not available here");
  return kernels(set);
}

int threads_or_throw(int threads) {
  if (threads < 1 || threads > kMostThreads) throw std::invalid_argument("threads must be 1 to 64");
  return threads;
}

}  // namespace

Grains::Grains(GrainState state, int threads, InstructionSet set)
    : state_(std::move(state)),
      kernels_(kernels_or_throw(set)),
      blocks_(state_),
      team_(std::make_unique<Team>(std::min(threads_or_throw(threads), blocks_.count()))),
      smallest_radius_(smallest_radius(state_)) {}

void Grains::restore(const GrainState& state) {
  state_ = state;
  blocks_.renew(state_);
  smallest_radius_ = smallest_radius(state_);
  if (book_) book_.emplace();
}

std::int64_t Grains::step(std::int64_t n) {
  made_ = 0;
  stop_ = false;
  failure_ = nullptr;
  if (n <= 0) return 0;
  // Two rounds a step: forces, then motion. Walls move between them, with the sum of their forces.
  TeamWork work;
  work.pieces = blocks_.count();
  work.piece = [this](unsigned round, int block) {
    if (round % 2 == 0)
      blocks_.load(state_, kernels_, block);
    else
      blocks_.move(state_, kernels_, block);
  };
  work.after_round = [this, n](unsigned round) {
    if (round % 2 == 0) {
      load_walls();
      return true;
    }
    finish_step();
    return !stop_ && made_ < n;
  };
  team_->run(work);
  if (failure_) std::rethrow_exception(failure_);
  return made_;
}

void Grains::load_walls() {
  blocks_.sum_walls(state_.walls);
  if (book_) book_->before_walls(state_, blocks_.friction_j());
  move_walls(state_);
  if (book_) book_->after_walls(state_);
}

void Grains::finish_step() {
  const FastestTwo squares = blocks_.fastest();
  const double first = std::sqrt(squares.first);
  const double second = std::max(std::sqrt(squares.second), wall_speed(state_));
  state_.neighbours.travelled_m += (first + second) * state_.time_step_s * kRoundingUp;
  ++state_.steps;
  state_.time_s += state_.time_step_s;
  ++made_;
  stop_ = !(first * state_.time_step_s < smallest_radius_);
  try {
    if (book_) book_->end_step(state_, blocks_.motion_totals());
    if (stop_ || state_.neighbours.travelled_m < state_.margin.near_m) return;
    renew_neighbours(state_);
    blocks_.renew(state_);
  } catch (...) {
    failure_ = std::current_exception();
    stop_ = true;
  }
}

void Grains::keep_ledger() {
  blocks_.book();
  book_.emplace();
}

std::optional<GrainLedger> Grains::ledger() const {
  return book_ ? book_->closed(state_) : std::nullopt;
}

void Grains::drive(const std::array<AxisDrive, 3>& drives) {
  check(drives);
  state_.walls.drive = drives;
  state_.walls.learned_rate_per_s = {};
  for (int a = 0; a < 3; ++a)
    state_.walls.stress_target_pa[a] = conjugate_stress(state_.walls, state_.box, a);
}

void Grains::set_friction_angle(double friction_angle) {
  state_.law.friction_angle = friction_angle;
}

void Grains::set_damping(double damping) { state_.law.damping = damping; }

void Grains::set_time_step(double time_step_s) { state_.time_step_s = time_step_s; }

void Grains::set_margin(const NeighbourMargin& margin) {
  state_.margin = margin;
  sort_grains(state_);
  blocks_.renew(state_);
}

void Grains::stop_motion() {
  if (book_) book_->before_change(state_);
  for (Grain& g : state_.grains) {
    std::fill_n(g.velocity, 3, 0.0);
    std::fill_n(g.spin, 3, 0.0);
  }
  if (book_) book_->after_change(state_);
}

void Grains::set_velocity(std::size_t index, const std::array<double, 3>& velocity_m_per_s) {
  Grain& grain = state_.grains.at(index);
  if (book_) book_->before_change(state_);
  std::copy(velocity_m_per_s.begin(), velocity_m_per_s.end(), grain.velocity);
  if (book_) book_->after_change(state_);
}

}  // namespace triax::sim
