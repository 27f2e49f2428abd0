// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/base/listeners.hpp"
#include "lab/collapse/assessment.hpp"
#include "lab/collapse/control_peak.hpp"
#include "lab/collapse/criteria.hpp"
#include "lab/collapse/last_readings.hpp"
#include "lab/collapse/limit_surface.hpp"
#include "lab/collapse/loss_of_control.hpp"
#include "lab/collapse/onset_interval.hpp"
#include "lab/collapse/onset_refiner.hpp"
#include "lab/collapse/placed_bursts.hpp"
#include "lab/collapse/second_order_work.hpp"
#include "lab/collapse/servo_search.hpp"
#include "lab/collapse/zero_stress.hpp"
#include "lab/measured/axis_rest.hpp"
#include "lab/measured/instant.hpp"
#include "lab/measured/largest_strength.hpp"
#include "lab/measured/path_history.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/measured/specimen_volume.hpp"
#include "lab/results/total_uncertainty.hpp"

namespace triax::lab {
namespace {

/// A few readings were enough to find some onsets: there is little noise then, and a fit through
/// dozens of them is the sharper one only if it follows them as closely as that noise lets it.
bool is_sharper(const std::optional<OnsetFit>& fit, const PathPoint& found) {
  if (!fit || !found.shortest_window()) return fit.has_value();
  const double noise = 3 * found.stress_variance;  // the value at the centre has a third of it
  return fit->stress_scatter < 3 * noise;
}

}  // namespace

struct CollapseMonitor::Impl {
  Impl(const RecordHeader& h, CollapseListeners all)
      : header(h),
        listeners(std::move(all)),
        volume(h.specimen),
        sampler(h.has_time),
        cycles(h.has_time),
        limit(h.specimen) {
    rates.on_point = [this](const PathPoint& point) { take(point); };
  }

  void start_stage(const State& state);
  void watch(const State& measured, const std::optional<Moment>& now);
  void take(const PathPoint& point);
  void judge(const PathPoint& point);
  void look_nearer(const PathPoint& point);
  void report_descent();
  void report_turn();
  void report_onset(const Instant& at, bool failed, std::string detail);
  void look_at_end();
  void sharpen();
  double last_of_path() const;
  void reach_unmeasured_volume(Instant& at) const;
  void bound_search();
  void place_turn(const OnsetFit& turn);
  void bound_turn(double reading);
  void place_descent(const Descent& descent);
  std::optional<StressInterval> interval_of(const OnsetFit& fit, const PathPoint& onset) const;
  std::optional<double> onset_with_volume(double FluidCompliance::*factor) const;
  void end_stage();
  Collapse verdict_so_far() const;

  const RecordHeader header;
  const CollapseListeners listeners;
  SpecimenVolume volume;
  PathSampler sampler;
  PathRates rates;
  AxisRest rest;
  Backbone backbone;
  ZeroStress zero_stress;
  CycleCounter cycles;
  PathHistory history;  ///< of the stage under way
  OnsetRefiner descent_onset, pore_turn;
  std::optional<double> sharpened_descent, sharpened_turn;  ///< readings that they began with
  int descent_revision = 0, turn_revision = 0;              ///< of what was taken from them
  Criteria criteria;
  // Those of which the verdict knows more than their findings.
  SecondOrderWork& work = criteria.of<SecondOrderWork>();
  LossOfControl& control = criteria.of<LossOfControl>();
  ControlPeak& control_peak = criteria.of<ControlPeak>();
  PlacedBursts bursts;
  std::optional<PathPoint> before_fall;  ///< the latest before control was lost
  LimitSurface limit;
  LargestStrength peak;
  std::optional<int> stage;
  bool drained = false;         ///< in the stage under way
  bool held_q = false;          ///< in the stage under way
  bool loop_of_volume = false;  ///< a strain path is prescribed, in the stage under way
  /// The turn of the pore pressure at held q, and the readings between which it is.
  struct PlacedTurn {
    Instant at;
    PathPoint point;
    double low = 0, high = 0;
  };
  std::optional<PlacedTurn> turn_of_pressure;  ///< of the stage under way
  std::optional<StageStart> start;             ///< of the stage under way
  bool held_undrained = false;                 ///< in any stage so far
  std::int64_t watched_states = 0, points = 0;
  std::optional<std::int64_t> first_state;
  std::optional<Nearest> nearest;
  std::optional<double> told_onset;
  bool turn_reported = false;
  std::optional<Instant> negative_at_end;  ///< of the stage that ended last
};

CollapseMonitor::CollapseMonitor(const RecordHeader& header, CollapseListeners listeners)
    : impl_(std::make_unique<Impl>(header, std::move(listeners))) {}

CollapseMonitor::~CollapseMonitor() = default;

void CollapseMonitor::watch(const State& state, const std::optional<Moment>& now) {
  if (complete(state)) impl_->watch(state, now);
}

void CollapseMonitor::watch(const State& state) {
  watch(state, moment_of(state, impl_->header.has_time));
}

void CollapseMonitor::watch_axis(const State& state) {
  constexpr std::int64_t kLongestGap = 6;  // readings across which a burst can be told
  const bool after_gap = state.reading > impl_->control.last_reading() + kLongestGap;
  if (!impl_->stage || *impl_->stage != state.stage || after_gap) impl_->start_stage(state);
  if (is_watched(impl_->header.stage(state.stage)))
    impl_->control.add_axis(state, impl_->header.has_time);
}

void CollapseMonitor::Impl::start_stage(const State& state) {
  end_stage();
  stage = state.stage;
  const StageInfo* info = header.stage(state.stage);
  criteria.start_stage(info);
  zero_stress.start_stage(info);
  rest.start_stage(info, header.has_time);
  backbone.start_stage(is_drained_frame(info));
  drained = info && info->drainage == Drainage::open;
  // What is consolidated again begins its cycles anew.
  if (!is_watched(info) && !cycles.has_liquefied()) cycles = CycleCounter(header.has_time);
  start.reset();
  turn_of_pressure.reset();
  loop_of_volume = info && info->strain_path_R;
  held_q = info && info->control == AxialControl::constant_q;
  held_undrained = held_undrained || (held_q && info->drainage == Drainage::closed);
}

void CollapseMonitor::Impl::watch(const State& measured, const std::optional<Moment>& now) {
  criteria.set_now(now);
  if (!stage || *stage != measured.stage) start_stage(measured);
  const State s = volume.with_fluid(measured, header.stage(measured.stage));
  if (!is_watched(header.stage(s.stage))) return;
  peak.add(s);
  ++watched_states;
  if (!first_state) first_state = s.reading;
  criteria.add_state(s, header.has_time);
  backbone.add(s, now);
  zero_stress.add_state(s, header.has_time, now);
  if (!drained) cycles.add(s);

  const auto sample = sampler.sample(s);
  if (!sample) return;
  if (!start) start = StageStart{s.q, s.p_eff, s.pore_pressure};
  history.add(*sample);
  rates.add(*sample);
  sharpen();
}

/// Sets to work on what was newly found, and follows it on.
void CollapseMonitor::Impl::sharpen() {
  const auto& descent = work.latest();
  if (descent && sharpened_descent != descent->onset.reading) {
    sharpened_descent = descent->onset.reading;
    descent_onset.begin(*sharpened_descent, held_q ? Witness::volume : Witness::second_order_work,
                        history);
    place_descent(*descent);
  } else {
    descent_onset.follow(history);
  }
  const auto& burst = control.found();
  if (burst && !bursts.of(*burst)) {
    bursts.place(control, history, before_fall,
                 {.q = start ? start->q : 0,
                  .held = held_q,
                  .drained = drained,
                  .compliance = drained ? std::nullopt : volume.compliance(),
                  .has_time = header.has_time});
    bound_search();
  }
  if (burst) descent_onset.finish(history, static_cast<double>(burst->instant.reading));
  const bool sought =
      std::exchange(descent_revision, descent_onset.revision()) != descent_onset.revision();
  if (sought && descent && is_sharper(descent_onset.onset(), descent->onset)) {
    const PathPoint onset = within_measured(descent_onset.onset()->point, history);
    auto interval = interval_of(*descent_onset.onset(), onset);
    // A loop that moves the volume after the displacement that it reads makes increments of its
    // own: until second-order work is surely negative the specimen may have followed those.
    if (loop_of_volume && interval && !descent->onset.shortest_window()) {
      const double proof =
          descent->evidence.reading + static_cast<double>(descent->evidence.window_readings) / 4;
      const auto seen = interval_over(
          history, onset, {descent->onset_low, std::max(descent->onset_high, proof)}, false);
      if (seen) interval = hull(*interval, *seen);
    }
    work.sharpen(onset, interval);
  }

  const auto& turn = control_peak.turn_of_pore_pressure();
  if (turn && sharpened_turn != turn) {
    sharpened_turn = turn;
    pore_turn.begin(*turn, Witness::pore_pressure, history);
    if (!pore_turn.onset()) bound_turn(*turn);
  } else {
    pore_turn.follow(history);
  }
  if (burst) pore_turn.finish(history, static_cast<double>(burst->instant.reading));
  const bool turned = std::exchange(turn_revision, pore_turn.revision()) != pore_turn.revision();
  if (turned && pore_turn.onset()) place_turn(*pore_turn.onset());
}

/// A turn that no fit shows, by what the windows saw.
void CollapseMonitor::Impl::bound_turn(double reading) {
  const Instant at = control_peak.finding()->instant;
  PathPoint point;
  point.reading = reading;
  point.q = at.q_pa.value_or(kMissing);
  point.p_eff = at.p_eff_pa.value_or(kMissing);
  turn_of_pressure = {at, point, reading, reading};
  bound_search();
}

/// At held q the volume turns before equilibrium is lost; whose increments the specimen follows in
/// between, those of the slow trend or of a servo that searches, nobody can read.
void CollapseMonitor::Impl::place_turn(const OnsetFit& turn) {
  // A reading is a mean over its interval, in which the loop works on.
  const double reach = StressSpan::kOf95 * std::hypot(turn.error, 1);
  turn_of_pressure = {instant_of(turn.point, header.has_time), turn.point,
                      turn.point.reading - reach, turn.point.reading + reach};
  bound_search();
}

/// Anew with all that is known by now of what came after the turn.
void CollapseMonitor::Impl::bound_search() {
  if (!turn_of_pressure) return;
  auto [at, point, low, high] = *turn_of_pressure;
  const double last = last_of_path();
  const double end = end_of_search(history, *start, std::min(high, last), last);
  at.interval = interval_over(history, point, {low, end, last}, false);
  reach_unmeasured_volume(at);
  const PlacedBurst* burst = control.found() ? bursts.of(*control.found()) : nullptr;
  if (burst && end >= last) {
    Instant fall = at;
    fall.interval = burst->fall ? burst->fall->interval : burst->interval;
    reach(at, fall);
  }
  control_peak.sharpen_turn(at);
}

/// A closed specimen swells as p′ falls, into what water and lines give way, and its area is taken
/// to stay: q is less than it seems, by the share of its volume.
void CollapseMonitor::Impl::reach_unmeasured_volume(Instant& at) const {
  const double swelling = kSwelling * std::log(start->p_eff / *at.p_eff_pa);
  if (!(swelling > 0) || !at.interval) return;
  Instant swollen = at;
  swollen.q_pa = *at.q_pa * (1 - swelling);
  swollen.interval.reset();
  reach(at, swollen);
}

double CollapseMonitor::Impl::last_of_path() const {
  const auto& burst = control.found();
  return burst ? static_cast<double>(burst->instant.reading) : history.last_reading();
}

/// Where the windows see it, before any fit.
void CollapseMonitor::Impl::place_descent(const Descent& descent) {
  PathPoint onset = within_measured(descent.onset, history);
  if (!descent.closed) onset = peak_of_readings(onset, history);
  work.sharpen(onset, interval_over(history, onset, {descent.onset_low, descent.onset_high},
                                    onset.shortest_window()));
}

/// Reading of the onset at one end of the interval of c; empty where no fit shows it.
std::optional<double> CollapseMonitor::Impl::onset_with_volume(
    double FluidCompliance::*factor) const {
  if (!volume.compliance() || drained) return std::nullopt;
  const FluidCompliance& c = *volume.compliance();
  const auto fit = descent_onset.with_volume(
      history, last_of_path(), [&](double u) { return (c.*factor - 1) * c.strain(u); });
  return fit ? std::optional(fit->point.reading) : std::nullopt;
}

/// Of a fit, up to the burst that ended what it could see.
std::optional<StressInterval> CollapseMonitor::Impl::interval_of(const OnsetFit& fit,
                                                                 const PathPoint& onset) const {
  const double last = last_of_path(), within = StressSpan::kOf95 * fit.error;
  double low = fit.point.reading, high = low;
  for (const auto& there :
       {onset_with_volume(&FluidCompliance::least), onset_with_volume(&FluidCompliance::most)})
    if (there) low = std::min(low, *there), high = std::max(high, *there);
  return interval_over(history, onset, {low - within, high + within, last}, false);
}

void CollapseMonitor::Impl::end_stage() {
  rates.finish();
  for (const PathPoint& point : rest.finish()) judge(point);
  sharpen();
  descent_onset.finish(history, history.last_reading());
  pore_turn.finish(history, history.last_reading());
  sharpen();
  bound_search();
  look_at_end();
  history.clear();
}

void CollapseMonitor::Impl::take(const PathPoint& point) {
  ++points;
  notify(listeners, &CollapseListener::second_order_work,
         SecondOrderWorkPoint{.reading = std::llround(point.reading),
                              .time_s = header.has_time ? point.progress : kMissing,
                              .work = point.work,
                              .normalised_error = point.normalised_error,
                              .window_readings = point.window_readings,
                              .axial_strain_path = header.has_time ? kMissing : point.progress});
  for (const PathPoint& driven : rest.add(point)) judge(driven);
}

void CollapseMonitor::Impl::judge(const PathPoint& point) {
  if (!control.found()) before_fall = point;
  look_nearer(point);
  limit.add(point.reading, point.q, point.p_eff);
  criteria.add_point(point, header.has_time);
  report_turn();
  report_descent();
}

void CollapseMonitor::Impl::look_nearer(const PathPoint& point) {
  if (point.normalised_error > ChangePoint::kUseless) return;
  if (nearest && nearest->normalised <= point.work.normalised) return;
  nearest = Nearest{std::llround(point.reading), point.work.normalised, point.normalised_error};
}

void CollapseMonitor::Impl::report_descent() {
  const auto& descent = work.latest();
  if (!work.latest_counts() || told_onset == descent->onset.reading) return;
  if (held_q && turn_reported) return;  // of the same onset
  told_onset = descent->onset.reading;
  const Instant at = instant_of(descent->best_onset(), header.has_time);
  report_onset(at, descent->drained,
               fmt::format("second-order work vanished at q {:.2f} kPa, p' {:.2f} kPa, η {:.3f} "
                           "and stays negative",
                           *at.q_pa / 1e3, *at.p_eff_pa / 1e3, *at.eta()));
}

/// At held q the volume, or the pore pressure, turned: q may be carried for long after that.
void CollapseMonitor::Impl::report_turn() {
  if (turn_reported || !control_peak.turned()) return;
  turn_reported = true;
  const auto turn = control_peak.finding();
  if (turn->instant.eta()) report_onset(turn->instant, false, turn->evidence);
}

void CollapseMonitor::Impl::report_onset(const Instant& at, bool failed, std::string detail) {
  const double q = *at.q_pa, p_eff = *at.p_eff_pa;
  const bool on_limit = limit.inside(q, p_eff, static_cast<double>(at.reading)) == false;
  failed = failed || !limit.needs_cohesion(q, p_eff).empty();
  notify(listeners, &CollapseListener::happened,
         Event{.reading = at.reading,
               .time_s = at.time_s,
               .kind = on_limit ? EventKind::limit_surface
                       : failed ? EventKind::failure
                                : EventKind::loss_of_sustainability,
               .detail = std::move(detail)});
}

/// Whether second-order work is negative in the last readings, which may be too few for a window.
void CollapseMonitor::Impl::look_at_end() {
  negative_at_end.reset();
  if (control.found() || (drained && !held_q && !loop_of_volume)) return;
  constexpr double kReadings = 64;
  const auto last = history.between(history.last_reading() - kReadings, history.last_reading());
  if (last.empty()) return;
  const auto strain = [](const PathSample& s) { return s.signal[PathSample::axial_strain]; };
  const auto whole = history.between(history.first_reading(), history.last_reading());
  const double mean_rate = (strain(last.back()) - strain(whole.front())) /
                           (history.last_reading() - history.first_reading());
  if (!(held_q ? contracts_at_end(last, drained) : softens_at_end(last, mean_rate))) return;
  const auto& s = last.back().signal;
  negative_at_end = Instant{.reading = std::llround(s[PathSample::Signal::reading]),
                            .q_pa = s[PathSample::Signal::q],
                            .p_eff_pa = s[PathSample::Signal::p_eff]};
}

void CollapseMonitor::interrupt() { impl_->stage.reset(); }

Collapse CollapseMonitor::Impl::verdict_so_far() const {
  // A burst that a growing load withdrew takes its fall with it.
  auto lost = control.lost();
  const PlacedBurst* burst = lost ? bursts.of(*lost) : nullptr;
  auto at_fall = burst ? burst->fall : std::nullopt;
  if (burst) lost->instant.interval = burst->interval;
  if (burst && burst->control) lost->instant = *burst->control;
  const auto peak_of_control = control_peak.finding();
  if (at_fall && control_peak.turned() && peak_of_control->instant.reading < at_fall->reading)
    reach(*at_fall, peak_of_control->instant);
  Collapse found = assess({.worst = work.worst(),
                           .at_held_q = work.at_held_q(),
                           .latest = work.latest(),
                           .loss_of_control = lost,
                           .loss = control.loss(),
                           .zero_stress = zero_stress.finding(),
                           .fall = at_fall,
                           .fall_work = burst ? burst->work : std::nullopt,
                           .control_peak = peak_of_control,
                           .turned_at_held_q = control_peak.turned(),
                           .negative_at_end = negative_at_end,
                           .volume_by_pore_pressure = held_undrained,
                           .states = watched_states,
                           .points = points,
                           .first_state = first_state,
                           .nearest = nearest,
                           .fall_at_rest = rest.unlikely(),
                           .backbone = backbone.worst(),
                           .cycles = &cycles,
                           .limit = limit,
                           .has_time = header.has_time},
                          criteria.criteria());
  if (found.onset) found.onset->total = total_uncertainty(*found.onset, header.specimen.diameter_m);
  return found;
}

Collapse CollapseMonitor::so_far() const { return impl_->verdict_so_far(); }

Collapse CollapseMonitor::of_the_axis() const {
  std::vector<Criterion> criteria = no_criteria("not assessed");
  for (const Criterion& one : impl_->criteria.criteria())
    if (one.name == LossOfControl::kName)
      *std::ranges::find(criteria, one.name, &Criterion::name) = one;
  return assess({.loss_of_control = impl_->control.lost(),
                 .loss = impl_->control.loss(),
                 .first_state = impl_->first_state,
                 .limit = impl_->limit,
                 .has_time = impl_->header.has_time},
                std::move(criteria));
}

Collapse CollapseMonitor::finish() {
  impl_->criteria.set_now(std::nullopt);
  impl_->end_stage();
  return impl_->verdict_so_far();
}

std::optional<CyclicLoading> CollapseMonitor::cyclic() const { return impl_->cycles.loading(); }

std::optional<Instant> CollapseMonitor::peak() const {
  const auto& peak = impl_->peak.state();
  return peak ? std::optional(instant_of(*peak, impl_->header.has_time)) : std::nullopt;
}

}  // namespace triax::lab
