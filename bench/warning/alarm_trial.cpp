// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/alarm_trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/warning/heard.hpp"
#include "bench/warning/readings_again.hpp"
#include "bench/warning/true_work.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {
namespace {

constexpr double kOf95 = 1.96;    ///< standard errors
constexpr double kInside = 0.95;  ///< of the limit surface, as LimitSurface has it

/// η up to which a specimen is inside its limit surface.
double limit_of(const lab::SpecimenInfo& specimen) {
  if (!specimen.limit_friction_angle_rad) return std::numeric_limits<double>::infinity();
  const double s = std::sin(*specimen.limit_friction_angle_rad);
  return kInside * 6 * s / (3 - s);
}

/// The error of measured work at the reading nearest to that.
class WorkErrors {
 public:
  void add(const lab::SecondOrderWorkPoint& point) {
    errors_.emplace_back(point.reading, point.normalised_error);
  }
  double at(std::int64_t reading) const {
    const auto near = std::ranges::min_element(
        errors_, {}, [&](const auto& one) { return std::abs(one.first - reading); });
    return near == errors_.end() ? 0 : kOf95 * near->second;
  }

 private:
  std::vector<std::pair<std::int64_t, double>> errors_;
};

void fill(const lab::Programme& programme, const lab::RecordHeader& header, AlarmTrial& r) {
  r.air = programme.specimen.saturation < 1;
  r.interruption = interruption(r.seed);
  for (const lab::StageInfo& info : header.stages)
    if (lab::is_watched(&info)) {
      r.under_force =
          info.control == lab::AxialControl::load || info.control == lab::AxialControl::constant_q;
    }
  for (const lab::Stage& one : programme.stages)
    if (one.role == lab::StageRole::shear) r.interval_s = one.logging.interval_s;
}

}  // namespace

lab::Programme varied_for_alarm(const Subject& subject, std::uint64_t seed,
                                Instruments& instruments) {
  lab::Programme programme = varied(subject, seed);
  instruments = static_cast<Instruments>(std::min(2, static_cast<int>(3 * choice(seed, 10))));
  if (instruments == Instruments::good)
    for (lab::Transducer& t : programme.transducers) t.noise_rms *= 0.5;
  if (instruments == Instruments::cheap)
    for (lab::Transducer& t : programme.transducers) t.step *= 8, t.noise_rms *= 3;
  const double slower = std::exp2(std::floor(7 * choice(seed, 11)) - 2);
  for (lab::Stage& stage : programme.stages) {
    if (stage.role != lab::StageRole::shear) continue;
    lab::Logging& logging = stage.logging;
    const double interval = std::clamp(logging.interval_s * slower, 0.1, 60.0);
    logging.averaging_s *= interval / logging.interval_s;
    logging.interval_s = interval;
  }
  if (choice(seed, 12) < 0.25) programme.specimen.saturation = 1 - 0.01 - 0.015 * choice(seed, 14);
  return interrupted(std::move(programme), interruption(seed), seed);
}

std::optional<lab::EarlierTest> as_recorded(const lab::RecordHeader& header,
                                            lab::TestSummary summary,
                                            const std::vector<lab::Forecast>& forecasts) {
  summary.truth.reset();
  return lab::earlier_test(header, summary, forecasts);
}

AlarmTest run_alarm_test(const Subject& subject, std::uint64_t seed) {
  AlarmTest test;
  AlarmTrial& r = test.trial;
  const lab::Programme programme = varied_for_alarm(subject, seed, r.instruments);
  lab::VirtualRig rig(programme, seed);
  test.header = rig.header();
  Heard heard;
  TrueWork work(limit_of(rig.header().specimen));
  WorkErrors errors;
  lab::SessionListener also;
  also.scanned = [&](const lab::Reading& reading, const lab::State& state) {
    test.readings.push_back(reading);
    const lab::StageInfo* stage = test.header.stage(state.stage);
    work.add(rig.specimen_state(), reading.number, lab::is_watched(stage));
  };
  std::vector<lab::Forecast> forecasts;
  also.foreseen = [&](const lab::Forecast& one) { forecasts.push_back(one); };
  also.second_order_work = [&](const lab::SecondOrderWorkPoint& point) { errors.add(point); };
  const lab::TestSummary summary = lab::run_session(rig, {}, {heard.listener(), also});

  r.fill(programme, subject.collapses, seed);
  fill(programme, test.header, r);
  r.density = fmt::format("{:.2f}", subject.programme.void_ratio);
  r.lost = summary.truth && summary.truth->lost_sustainability;
  r.least_work = work.least();
  r.work_error = errors.at(work.at_reading());
  if (r.lost) test.truth = summary.truth;
  heard.judge(test.truth ? &*test.truth : nullptr, r);
  test.earlier = as_recorded(test.header, summary, forecasts);
  return test;
}

AlarmTrial heard_again(const AlarmTest& test, const lab::EarlierTests& earlier,
                       const lab::SessionListeners& also) {
  ReadingsAgain again(test.header, test.readings);
  Heard heard;
  lab::SessionListeners listeners = also;
  listeners.push_back(heard.listener());
  lab::run_session(again, {.earlier = earlier}, listeners);
  AlarmTrial r = test.trial;
  heard.judge(test.truth ? &*test.truth : nullptr, r);
  return r;
}

}  // namespace triax::bench
