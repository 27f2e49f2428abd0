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
}

std::int64_t Grains::step(std::int64_t n) {
  made_ = 0;
  stop_ = false;
  failure_ = nullptr;
  MeetingPoint all(team_->size());
  team_->run([&](int thread) { run(thread, n, all); });
  if (failure_) std::rethrow_exception(failure_);
  return made_;
}

void Grains::run(int thread, std::int64_t n, MeetingPoint& all) {
  for (std::int64_t s = 0; s < n && !stop_; ++s) {
    const int begin = blocks_.count() * thread / team_->size(),
              end = blocks_.count() * (thread + 1) / team_->size();
    for (int b = begin; b < end; ++b) blocks_.load(state_, kernels_, b);
    all.wait();
    if (thread == 0) {
      blocks_.sum_walls(state_.walls);
      move_walls(state_);
    }
    for (int b = begin; b < end; ++b) blocks_.move(state_, kernels_, b);
    all.wait();
    if (thread == 0) finish_step();
    all.wait();
  }
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
  if (stop_ || state_.neighbours.travelled_m < state_.margin.near_m) return;
  try {
    renew_neighbours(state_);
    blocks_.renew(state_);
  } catch (...) {
    failure_ = std::current_exception();
    stop_ = true;
  }
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
  for (Grain& g : state_.grains) {
    std::fill_n(g.velocity, 3, 0.0);
    std::fill_n(g.spin, 3, 0.0);
  }
}

void Grains::set_velocity(std::size_t index, const std::array<double, 3>& velocity_m_per_s) {
  std::copy(velocity_m_per_s.begin(), velocity_m_per_s.end(), state_.grains.at(index).velocity);
}

}  // namespace triax::sim
