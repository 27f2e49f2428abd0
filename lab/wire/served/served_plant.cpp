// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/served/served_plant.hpp"

#include <utility>

namespace triax::lab {
namespace {

PressureDemand pressure_demand(const ControllerSettings& s) {
  using enum ControllerMode;
  if (s.mode == ramp) return {.rate_pa_per_s = s.rate_pa_per_s, .target_pa = {}};
  if (s.mode == ramp_to_target) return {.rate_pa_per_s = s.rate_pa_per_s, .target_pa = s.target_pa};
  return {};
}

FrameState state_after(Ticked::End end, FrameState before) {
  switch (end) {
    case Ticked::End::none:
      return before;
    case Ticked::End::cut:
      return FrameState::cannot_follow;
    case Ticked::End::stopped:
      return FrameState::end_of_travel;
    case Ticked::End::lies_down:
      return FrameState::on_stop;
  }
  return before;
}

/// A perfect instrument that no file describes; the stages are the client's.
Stage no_stage() {
  Stage stage;
  stage.name = "on the wire";
  return stage;
}

}  // namespace

ServedPlant::ServedPlant(const Programme& programme, std::uint64_t seed)
    : programme_(as_far_as_simulated(programme)),
      seed_(seed),
      apparatus_(programme_, seed),
      stage_(no_stage()) {
  look();
}

void ServedPlant::order_axis(const FrameSettings& settings) { axis_.order(settings, time_s_); }

void ServedPlant::look() {
  reading_ = Reading();
  reading_.number = ticks_;
  reading_.time_s = time_s_;
  apparatus_.look(reading_);
}

void ServedPlant::tick(double dt_s) {
  PlantDemand demand;
  demand.valve_open = valve_open_;
  demand.cell = pressure_demand(cell_);
  demand.back = pressure_demand(back_);
  if (back_.mode == ControllerMode::flow) demand.outflow_m3_per_s = back_.flow_m3_per_s;
  demand.axis = axis_.demand(time_s_, dt_s);
  const bool stands =
      frame_state_ == FrameState::cannot_follow || frame_state_ == FrameState::end_of_travel;
  if (!stands) {
    const Ticked done =
        apparatus_.tick(demand, {.stage = stage_,
                                 .time_s = time_s_,
                                 .dt_s = dt_s,
                                 .running = axis_.settings().mode != FrameMode::stop,
                                 .readings = ticks_ + 2});
    frame_state_ = state_after(done.end, frame_state_);
    if (!done.why.empty()) why_ = done.why;
  }
  time_s_ += dt_s;
  ++ticks_;
  look();
}

void ServedPlant::add_fault(Fault fault) {
  fault.from_s = time_s_;
  programme_.faults.push_back(std::move(fault));
  apparatus_.set_faults(programme_.faults);
}

void ServedPlant::clear_faults() {
  programme_.faults.clear();
  apparatus_.set_faults({});
}

}  // namespace triax::lab
