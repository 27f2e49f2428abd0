// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/interruption.hpp"

#include <algorithm>
#include <optional>

#include "bench/detection/trial.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {
namespace {

constexpr std::uint64_t kChoice = 13;
constexpr double kShare = 0.15;  ///< of the seeds, for each
constexpr double kOnTheWay = 0.4, kAlong = 0.05;
constexpr double kRests = 0.25, kGoesBack = 0.125;  ///< of the time so far

/// Seconds from the start of the programme's last stage to where it is interrupted.
double when(const lab::Programme& programme, std::uint64_t seed) {
  lab::VirtualRig rig(programme, seed);
  std::optional<int> stage;
  double begin_s = 0, now_s = 0;
  lab::SessionListener listener;
  listener.scanned = [&](const lab::Reading& reading, const lab::State&) {
    now_s = reading.time_s;
    if (stage != reading.stage) begin_s = now_s;
    stage = reading.stage;
  };
  const auto truth = lab::run_session(rig, {}, {listener}).truth;
  if (truth && truth->time_s && *truth->time_s > begin_s)
    return kOnTheWay * (*truth->time_s - begin_s);
  return kAlong * (now_s - begin_s);
}

/// The stage at `pace` times its rates, for that long.
lab::Stage part_of(const lab::Stage& stage, double pace, double seconds, const char* name) {
  lab::Stage part = stage;
  part.name += name;
  part.axial_rate_m_per_s *= pace;
  part.load_rate_n_per_s *= pace;
  for (lab::PressureDemand* demand : {&part.cell, &part.back}) {
    demand->rate_pa_per_s *= pace;
    if (pace <= 0) demand->target_pa.reset();
  }
  part.end.push_back({lab::EndQuantity::time, seconds, {}});
  return part;
}

}  // namespace

Interruption interruption(std::uint64_t seed) {
  const double x = choice(seed, kChoice);
  if (x < kShare) return Interruption::pause;
  return x < 2 * kShare ? Interruption::loop : Interruption::none;
}

lab::Programme interrupted(lab::Programme programme, Interruption how, std::uint64_t seed) {
  const lab::Stage shear = programme.stages.back();
  if (how == Interruption::none || shear.role != lab::StageRole::shear || shear.load_step_n > 0 ||
      shear.axial == lab::AxialAction::dead_load)
    return programme;
  const double so_far = when(programme, seed);
  programme.stages.back() = part_of(shear, 1, so_far, ", begun");
  programme.stages.push_back(how == Interruption::pause
                                 ? part_of(shear, 0, kRests * so_far, ", at rest")
                                 : part_of(shear, -1, kGoesBack * so_far, ", back"));
  programme.stages.push_back(shear);
  return programme;
}

}  // namespace triax::bench
