// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/trial.hpp"

#include <algorithm>
#include <cmath>

#include "bench/detection/naive_methods.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {
namespace {

/// The naive methods over the states that the monitor watches, too.
class Naive {
 public:
  explicit Naive(const lab::RecordHeader& header) : header_(header) {}

  void add(const lab::State& state) {
    if (!lab::complete(state)) return;
    if (stage_ != state.stage) {
      neighbours_.start_stage();
      average_.start_stage();
    }
    stage_ = state.stage;
    if (!lab::is_watched(header_.stage(state.stage))) return;
    maximum_.add(state);
    neighbours_.add(state);
    average_.add(state);
  }
  std::array<std::optional<Onset>, 3> onsets() const {
    return {maximum_.onset(), neighbours_.onset(), average_.onset()};
  }

 private:
  const lab::RecordHeader& header_;
  std::optional<int> stage_;
  MaximumOfQ maximum_;
  NeighbouringIncrements neighbours_;
  MovingAverage average_{50};
};

Outcome outcome_of(const TrialResult& result, const std::optional<Onset>& onset) {
  Outcome o{.collapses = result.collapses, .detected = onset.has_value()};
  if (!onset || !result.truth_lost) return o;
  o.eta_error = std::fabs(onset->eta - result.truth_eta);
  o.delay = onset->reading - result.truth_reading;
  return o;
}

/// Number of the first reading at or after a time; readings are numbered from 0.
std::int64_t first_reading_at(const std::vector<double>& times, double time_s) {
  return std::ranges::lower_bound(times, time_s - 1e-9) - times.begin();
}

/// Scales everything that follows the consolidation stress: effective cell pressures, and the q at
/// which stages end.
void scale_stress(lab::Programme& programme, double factor) {
  const double back = programme.initial_back_pressure_pa;
  for (lab::Stage& stage : programme.stages) {
    if (stage.role == lab::StageRole::consolidation) {
      const auto moved = [&](std::optional<double>& p) {
        if (p) *p = back + factor * (*p - back);
      };
      moved(stage.cell.target_pa);
      for (lab::EndCondition& end : stage.end)
        if (end.quantity == lab::EndQuantity::cell_pressure) moved(end.above);
    }
    for (lab::EndCondition& end : stage.end)
      for (auto* limit : {&end.above, &end.below})
        if (end.quantity == lab::EndQuantity::deviator_stress && *limit) **limit *= factor;
  }
}

void scale_rates(lab::Programme& programme, double factor) {
  for (lab::Stage& stage : programme.stages) {
    if (stage.role != lab::StageRole::shear) continue;
    stage.axial_rate_m_per_s *= factor;
    stage.load_rate_n_per_s *= factor;
    stage.cell.rate_pa_per_s *= factor;
    stage.back.rate_pa_per_s *= factor;
    stage.time_limit_s /= factor;
  }
}

}  // namespace

void TrialHeader::fill(const lab::Programme& of, bool expected_to_collapse,
                       std::uint64_t its_seed) {
  programme = of.name;
  type = of.type;
  material = of.material.name;
  seed = its_seed;
  collapses = expected_to_collapse;
}

double choice(std::uint64_t seed, std::uint64_t number) {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15U + (number + 1) * 0xD1B54A32D192ED03U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

lab::Programme varied(const Subject& subject, std::uint64_t seed) {
  lab::Programme programme = subject.programme;
  programme.material.material = lab::made_anew(programme.material);
  const double noise = std::exp2(std::floor(4 * choice(seed, 0)) - 1);
  const double step = choice(seed, 1) < 0.5 ? 1 : 2;
  for (lab::Transducer& transducer : programme.transducers) {
    transducer.noise_rms *= noise;
    transducer.step *= step;
  }
  programme.void_ratio += 0.02 * (choice(seed, 2) - 0.5);
  scale_stress(programme, 0.9 + 0.2 * choice(seed, 3));
  scale_rates(programme, std::exp2(2 * choice(seed, 4) - 1));
  programme.seed = seed;
  return programme;
}

TrialResult run_trial(const Subject& subject, std::uint64_t seed) {
  const lab::Programme programme = varied(subject, seed);
  lab::VirtualRig rig(programme, seed);
  return judge_trial(programme, subject.collapses, seed, rig);
}

TrialResult judge_trial(const lab::Programme& programme, bool collapses, std::uint64_t seed,
                        lab::BackEnd& rig) {
  Naive naive(rig.header());
  lab::SessionListener listener;
  std::vector<double> times;
  listener.scanned = [&](const lab::Reading& reading, const lab::State& state) {
    times.push_back(reading.time_s);
    naive.add(state);
  };
  const lab::TestSummary summary = lab::run_session(rig, {}, {listener});

  TrialResult r;
  r.fill(programme, collapses, seed);
  r.readings = summary.readings;
  if (summary.truth && summary.truth->lost_sustainability) {
    r.truth_lost = true;
    r.truth_time_s = *summary.truth->time_s;
    r.truth_q_pa = *summary.truth->q_pa;
    r.truth_p_pa = *summary.truth->p_eff_pa;
    r.truth_eta = r.truth_q_pa / r.truth_p_pa;
    r.truth_reading = first_reading_at(times, r.truth_time_s);
  }
  const lab::Collapse& c = summary.collapse;
  r.kind = c.judged ? std::string(lab::to_string(c.kind)) : "not judged";
  std::optional<Onset> ours;
  if (c.detected() && c.onset) ours = Onset{c.onset->reading, c.onset->eta().value_or(0)};
  if (ours) r.interval = c.onset->interval;
  r.outcomes[0] = outcome_of(r, ours);
  if (ours && r.truth_lost && c.onset_detected_at)
    r.outcomes[0].notice_delay = c.onset_detected_at->reading - r.truth_reading;
  const auto others = naive.onsets();
  for (std::size_t i = 0; i < others.size(); ++i) r.outcomes[i + 1] = outcome_of(r, others[i]);
  return r;
}

}  // namespace triax::bench
