// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/naive_methods.hpp"

#include <algorithm>
#include <cmath>

namespace triax::bench {

double second_order_work(double dq, double dp, double axial, double volumetric) {
  return dq * (axial - volumetric / 3) + dp * volumetric;
}

void MaximumOfQ::add(const lab::State& state) {
  const double strength = std::fabs(state.q);
  if (strength > top_) {
    top_ = least_after_ = strength;
    at_top_ = {state.reading, state.eta()};
  }
  least_after_ = std::min(least_after_, strength);
}

std::optional<Onset> MaximumOfQ::onset() const {
  if (!(top_ > 0) || least_after_ > (1 - kLoss) * top_) return std::nullopt;
  return at_top_;
}

void NeighbouringIncrements::add(const lab::State& state) {
  if (last_ && !onset_) {
    const double work = second_order_work(state.q - last_->q, state.p_eff - last_->p_eff,
                                          state.strain.axial - last_->strain.axial,
                                          state.volumetric_strain - last_->volumetric_strain);
    if (work < 0) onset_ = Onset{state.reading, state.eta()};
  }
  last_ = state;
}

void MovingAverage::start_stage() {
  states_.clear();
  run_ = 0;
}

void MovingAverage::add(const lab::State& state) {
  if (onset_) return;
  states_.push_back(state);
  if (states_.size() <= window_) return;
  // Two neighbouring averages differ by what came in and what went out, over the window.
  const lab::State& out = states_.front();
  const double work = second_order_work(state.q - out.q, state.p_eff - out.p_eff,
                                        state.strain.axial - out.strain.axial,
                                        state.volumetric_strain - out.volumetric_strain);
  const lab::State& middle = states_[states_.size() / 2];
  states_.pop_front();
  if (!(work < 0)) {
    run_ = 0;
    return;
  }
  if (run_++ == 0) start_of_run_ = {middle.reading, middle.eta()};
  if (run_ == window_) onset_ = start_of_run_;
}

}  // namespace triax::bench
