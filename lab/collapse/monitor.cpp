#include "lab/collapse/monitor.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/collapse/control_peak.hpp"
#include "lab/collapse/descent.hpp"
#include "lab/collapse/fall_fit.hpp"
#include "lab/collapse/instant.hpp"
#include "lab/collapse/limit_surface.hpp"
#include "lab/collapse/loss_of_control.hpp"
#include "lab/collapse/onset_refiner.hpp"
#include "lab/collapse/path_sampler.hpp"
#include "lab/collapse/verdict.hpp"

namespace triax::lab {
namespace {

/// A few readings were enough to find some onsets: there is little noise then, and a fit through
/// dozens of them is the sharper one only if it follows them as closely as that noise lets it.
bool is_sharper(const std::optional<OnsetFit>& fit, const PathPoint& found) {
  if (!fit || !found.shortest_window()) return fit.has_value();
  const double noise = 3 * found.stress_variance;  // the value at the centre has a third of it
  return fit->stress_scatter < 8 * noise;
}

}  // namespace

struct CollapseMonitor::Impl {
  explicit Impl(const RecordHeader& h) : header(h), sampler(h.has_time), limit(h.specimen) {}

  void start_stage(const State& state);
  void watch(const State& state);
  void take(const PathPoint& point, const CollapseMonitor& outer);
  void tell_of_descent(const CollapseMonitor& outer);
  void sharpen();
  void place_fall(const Finding& burst);
  void end_stage();
  Collapse judge() const;

  const RecordHeader header;
  PathSampler sampler;
  PathRates rates;
  PathHistory history;  ///< of the stage under way
  OnsetRefiner descent_onset, pore_turn;
  std::optional<double> sharpened_descent, sharpened_turn;  ///< readings that they began with
  DescentTracker descents;
  LossOfControl control;
  std::optional<Instant> fall;  ///< where a sudden loss of control began
  std::optional<FallWork> fall_work;
  std::optional<PathPoint> before_fall;  ///< the latest before control was lost
  ControlPeak control_peak;
  LimitSurface limit;
  std::optional<State> peak;
  std::optional<int> stage;
  bool held_q = false;          ///< in the stage under way
  bool held_undrained = false;  ///< in any stage so far
  std::int64_t watched_states = 0, points = 0;
  std::optional<double> told_onset;
  std::optional<Descent> held_descent;  ///< the first that lasted
};

CollapseMonitor::CollapseMonitor(const RecordHeader& header)
    : impl_(std::make_unique<Impl>(header)) {
  impl_->rates.on_point = [this](const PathPoint& point) { impl_->take(point, *this); };
}

CollapseMonitor::~CollapseMonitor() = default;

void CollapseMonitor::watch(const State& state) {
  if (complete(state)) impl_->watch(state);
}

void CollapseMonitor::Impl::start_stage(const State& state) {
  end_stage();
  stage = state.stage;
  const StageInfo* info = header.stage(state.stage);
  descents.start_stage();
  control.start_stage(info);
  control_peak.start_stage(info);
  held_q = info && info->control == AxialControl::constant_q;
  held_undrained = held_undrained || (held_q && info->drainage == Drainage::closed);
}

void CollapseMonitor::Impl::watch(const State& s) {
  if (!stage || *stage != s.stage) start_stage(s);
  if (!is_watched(header.stage(s.stage))) return;
  if (!peak || std::fabs(s.q) > std::fabs(peak->q)) peak = s;
  ++watched_states;
  control.add(s, header.has_time);

  const auto sample = sampler.sample(s);
  if (!sample) return;
  history.add(*sample);
  rates.add(*sample);
  sharpen();
}

/// Sets to work on what was newly found, and follows it on.
void CollapseMonitor::Impl::sharpen() {
  const auto& descent = descents.latest();
  if (descent && sharpened_descent != descent->onset.reading) {
    sharpened_descent = descent->onset.reading;
    descent_onset.begin(*sharpened_descent, held_q ? Witness::volume : Witness::second_order_work,
                        history);
  } else {
    descent_onset.follow(history);
  }
  const auto& burst = control.finding();
  if (burst && control.sudden() && !fall) place_fall(*burst);
  if (burst) descent_onset.finish(history, static_cast<double>(burst->instant.reading));
  if (descent && is_sharper(descent_onset.onset(), descent->onset))
    descents.sharpen(descent_onset.onset()->point);

  const auto& turn = control_peak.turn_of_pore_pressure();
  if (turn && sharpened_turn != turn) {
    sharpened_turn = turn;
    pore_turn.begin(*turn, Witness::pore_pressure, history);
  } else {
    pore_turn.follow(history);
  }
  if (burst) pore_turn.finish(history, static_cast<double>(burst->instant.reading));
}

void CollapseMonitor::Impl::place_fall(const Finding& burst) {
  constexpr double kBefore = 24;  // readings
  const auto last = static_cast<double>(burst.instant.reading);
  const auto fit = fit_fall(history.between(last - kBefore, last), held_q);
  fall = fit ? instant_of(*fit, header.has_time) : burst.instant;
  if (before_fall)
    fall_work = work_of_fall(control.fall()->before, control.fall()->after, *before_fall);
}

void CollapseMonitor::Impl::end_stage() {
  rates.finish();
  sharpen();
  descent_onset.finish(history, history.last_reading());
  pore_turn.finish(history, history.last_reading());
  sharpen();
  history.clear();
}

void CollapseMonitor::Impl::take(const PathPoint& point, const CollapseMonitor& outer) {
  ++points;
  if (!control.finding()) before_fall = point;
  limit.add(point);
  descents.add(point);
  control_peak.add(point, header.has_time);
  if (outer.on_point) {
    outer.on_point({.reading = std::llround(point.reading),
                    .time_s = header.has_time ? point.progress : kMissing,
                    .work = point.work,
                    .normalised_error = point.normalised_error,
                    .window_readings = point.window_readings,
                    .axial_strain_path = header.has_time ? kMissing : point.progress});
  }
  tell_of_descent(outer);
}

void CollapseMonitor::Impl::tell_of_descent(const CollapseMonitor& outer) {
  const auto& descent = descents.latest();
  if (!descent) return;
  const bool costly = descent->strength_loss() >= Descent::kWorthALoss;
  const bool yields = held_q && lasts_at_held_q(*descent);
  const bool known = held_descent && held_descent->onset.reading == descent->onset.reading;
  if (known || (yields && !held_descent)) held_descent = descent;
  if (!(costly || yields) || told_onset == descent->onset.reading) return;
  told_onset = descent->onset.reading;
  const Instant at = instant_of(descent->best_onset(), header.has_time);
  const bool inside = limit.inside(descent->best_onset().eta());
  if (!outer.on_event) return;
  outer.on_event(
      {.reading = at.reading,
       .time_s = at.time_s,
       .kind = inside ? "loss_of_sustainability" : "limit_surface",
       .detail = fmt::format("second-order work vanished at q {:.2f} kPa, p' {:.2f} kPa, η "
                             "{:.3f} and stays negative",
                             *at.q_pa / 1e3, *at.p_eff_pa / 1e3, descent->best_onset().eta())});
}

void CollapseMonitor::interrupt() { impl_->stage.reset(); }

Collapse CollapseMonitor::Impl::judge() const {
  const auto& latest = descents.latest();
  const bool same = latest && held_descent && held_descent->onset.reading == latest->onset.reading;
  auto control_peak_found = control_peak.finding();
  if (control_peak_found && pore_turn.onset())
    control_peak_found->instant = instant_of(pore_turn.onset()->point, header.has_time);
  return verdict({.worst = descents.worst(),
                  .at_held_q = same ? latest : held_descent,
                  .loss_of_control = control.finding(),
                  .fall = fall,
                  .fall_work = fall_work,
                  .control_peak = control_peak_found,
                  .volume_by_pore_pressure = held_undrained,
                  .states = watched_states,
                  .points = points,
                  .limit = limit,
                  .has_time = header.has_time});
}

Collapse CollapseMonitor::so_far() const { return impl_->judge(); }

Collapse CollapseMonitor::finish() {
  impl_->end_stage();
  return impl_->judge();
}

std::optional<Instant> CollapseMonitor::peak() const {
  if (!impl_->peak) return std::nullopt;
  return instant_of(*impl_->peak, impl_->header.has_time);
}

}  // namespace triax::lab
