// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/simulated/virtual_apparatus.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/rig/stage_words.hpp"

namespace triax::lab {
namespace {

Plant make_plant(const Programme& programme) {
  try {
    return Plant(programme);
  } catch (const std::invalid_argument& error) {
    throw BadInput(programme.source, 0, error.what());
  }
}

}  // namespace

VirtualApparatus::VirtualApparatus(const Programme& p, std::uint64_t seed)
    : material_(p.material),
      source_(p.source),
      built_height_m_(p.specimen.height_m),
      travel_m_(p.frame.travel_m),
      plant_(make_plant(p)),
      instruments_(p, seed),
      truth_(plant_.specimen().law()) {
  ask_devices();
}

void VirtualApparatus::ask_devices() {
  const auto said = [](const ControllerState& c) {
    return DeviceStates::Controller{.asked_pa = c.asked_pa, .full = c.full, .empty = c.empty};
  };
  const PlantState& now = plant_.state();
  devices_.cell = said(now.cell);
  devices_.back = said(now.back);
  devices_.piston_force_n = plant_.specimen().axial_force(now.specimen);
}

void VirtualApparatus::look(Reading& reading) {
  instruments_.look(plant_, reading.time_s, reading);
  for (const auto& row : raw_channels())
    devices_.saturated[index(row.quantity)] = instruments_.saturated(row.quantity);
}

std::vector<std::string> VirtualApparatus::begin_shear() {
  const sim::SpecimenState& now = plant_.state().specimen;
  shear_height_m_ = now.height_m;
  std::vector<std::string> warnings;
  for (const auto& outside : {void_ratio_outside(material_, now.material.void_ratio),
                              p_eff_outside(material_, now.material.p())})
    if (outside) warnings.push_back("at the start of shear " + *outside);
  return warnings;
}

std::optional<Truth> VirtualApparatus::truth() const {
  return truth_.truth(plant_.state().specimen);
}

void VirtualApparatus::set_faults(const std::vector<Fault>& faults) {
  plant_.set_faults(faults);
  instruments_.set_faults(faults);
}

void VirtualApparatus::warn_once(bool& told, const std::string& text, Ticked& done) {
  if (!std::exchange(told, true)) done.warnings.push_back(text);
}

/// False where the test cannot go on after this step.
bool VirtualApparatus::survived(const sim::SpecimenStep& step, const Tick& tick, Ticked& done) {
  if (step.outcome == sim::StepOutcome::failed) {
    // A test that has readings is kept: the law may end where the specimen is liquefied.
    if (!step.law_ended || tick.readings <= 1)
      throw WorkFailed(fmt::format("{}: stage \"{}\" at {:.6g} s: {}", source_, tick.stage.name,
                                   tick.time_s, step.message));
    done.end = Ticked::End::cut;
    done.why = ended_by_law(tick.stage, tick.time_s, step);
    return false;
  }
  if (step.outcome == sim::StepOutcome::inaccurate)
    warn_once(
        accuracy_warned_,
        fmt::format("from {:.6g} s on, the integration of the law is less accurate than specified",
                    tick.time_s),
        done);
  if (step.outcome == sim::StepOutcome::lost_control) {
    done.end = Ticked::End::cut;
    done.why = control_lost(tick.stage, tick.time_s, step);
    return false;
  }
  if (step.state.pore_pressure < 0)
    warn_once(cavitation_warned_,
              fmt::format("pore pressure below 0 from {:.6g} s on: cavitation is not modelled",
                          tick.time_s),
              done);
  return true;
}

Ticked VirtualApparatus::tick(const PlantDemand& demand, const Tick& tick) {
  Ticked done;
  if (!lies_) {
    const sim::SpecimenState start = plant_.state().specimen;
    const sim::SpecimenStep& step = plant_.advance(demand, tick.time_s, tick.dt_s);
    ask_devices();
    const TrueStep one{.time_s = tick.time_s,
                       .dt_s = tick.dt_s,
                       .before = start,
                       .step = step,
                       .sheared = tick.stage.role == StageRole::shear && tick.running,
                       .height_at_shear_m = shear_height_m_.value_or(built_height_m_)};
    if (step.outcome != sim::StepOutcome::failed) truth_.add_work(one);
    if (!survived(step, tick, done)) return done;
    if (const std::string news = truth_.add_run_away(one); !news.empty())
      done.events.push_back({.kind = EventKind::run_away, .detail = news});
    keep_within_travel(step, tick, done);
  }
  done.passed_s = tick.dt_s;
  return done;
}

/// A crosshead stops at the end of its travel, and the test with it; a cap that fell there lies,
/// and what is left of the specimen, which is not moved on, is still read.
void VirtualApparatus::keep_within_travel(const sim::SpecimenStep& step, const Tick& tick,
                                          Ticked& done) {
  constexpr double kRoundOff = 1 - 1e-9;
  const double displaced = built_height_m_ - step.state.height_m;
  if (std::fabs(displaced) < travel_m_ * kRoundOff) return;
  lies_ = step.at_stop && tick.running && fell(step.state);
  done.end = lies_ ? Ticked::End::lies_down : Ticked::End::stopped;
  done.why = travel_reached(tick.stage, tick.time_s + tick.dt_s, travel_m_, displaced);
}

}  // namespace triax::lab
