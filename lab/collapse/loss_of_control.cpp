// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/loss_of_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/instant.hpp"

namespace triax::lab {
namespace {

std::string in_readings(std::size_t count) {
  return count == 1 ? "one reading" : fmt::format("{} readings", count);
}

namespace limits = assessment_limits;

/// Per second where there is time, so that a logger that slows down makes no burst; else per
/// reading.
double lapse(const State& from, const State& to, bool has_time) {
  return has_time ? to.time_s - from.time_s : static_cast<double>(to.reading - from.reading);
}

}  // namespace

void LossOfControl::start_stage(const StageInfo* stage) {
  LossOfControl next;
  next.looked_ = looked_;
  next.now_ = now_;
  next.run_ = std::move(run_);
  next.earlier_ = std::move(earlier_);
  next.step_ = std::move(step_);
  next.before_ = before_;
  next.control_ = stage ? stage->control : AxialControl::unknown;
  next.drainage_ = stage ? stage->drainage : Drainage::unknown;
  for (Run* run : {&next.run_, &next.earlier_}) {
    run->over = run->finding.has_value();
    if (run->loss) run->loss->start_stage(stage);
  }
  *this = std::move(next);
}

void LossOfControl::add_state(const State& state, bool has_time) {
  ++whole_;
  add(state, has_time);
}

void LossOfControl::add_axis(const State& state, bool has_time) {
  whole_ = 0;
  add(state, has_time);
}

void LossOfControl::add(const State& state, bool has_time) {
  const State before = before_;
  if (earlier_.loss) earlier_.loss->add(state);
  if (run_.finding) follow(state);
  if (control_ != AxialControl::displacement && !run_.finding) look(before, state, has_time);
  before_ = state;
}

void LossOfControl::look(const State& before, const State& state, bool has_time) {
  looked_ = true;
  ++count_;
  if (control_ == AxialControl::constant_q) check_held_q(state, has_time);
  check_bursts(state, has_time);
  const bool carries_load = control_ != AxialControl::unknown;
  if (carries_load && steps_ < kReference && !run_.finding) check_leap(before, state, has_time);
  if (run_.finding) follow(state);
}

void LossOfControl::begin(const State& from, std::string evidence, bool has_time) {
  run_.finding = Finding{
      .instant = instant_of(from, has_time), .evidence = std::move(evidence), .noticed = now_};
  run_.before = from;
  run_.previous = before_;
  run_.loss.emplace(from, recent_.back().strain.axial - from.strain.axial, drainage_);
  run_.under_load = control_ == AxialControl::load;
}

void LossOfControl::follow(const State& state) {
  run_.loss->add(state);
  run_.add(state);
  const double before = std::fabs(run_.before.q);
  const bool returned = run_.carried_on() || run_.loss->came_back();
  if (returned && run_.loss->largest_since() >= (1 + limits::kGrowth) * before) watch_anew();
}

/// The rates are others now: they are learned anew.
void LossOfControl::watch_anew() {
  if (!earlier_.lost()) earlier_ = std::move(run_);
  run_ = {};
  count_ = steps_ = 0;
  held_count_ = 0;
  below_ = 0;
  q_mean_ = q_square_ = 0;
  largest_rate_ = mean_rate_ = mean_pore_rate_ = 0;
}

double LossOfControl::carried_load(const State& state) {
  return std::fabs(state.q) * (1 - volumetric_strain(state.strain)) / (1 - state.strain.axial);
}

void LossOfControl::Run::add(const State& state) {
  if (over || std::isnan(state.q)) return;
  const double q = std::fabs(state.q);
  load = carried_load(state);
  if (readings++ == 0) {
    least = q;
    first_load = min_load = load;
  }
  min_load = std::min(min_load, load);
  least = std::min(least, q);
  last = q;
  if (!under_load || readings > kRecent) return;
  const auto outran = [&](const State& from) {
    const double leap = std::fabs(state.strain.axial - from.strain.axial);
    return leap >= assessment_limits::kRunaway && load / carried_load(from) - 1 < leap / 2;
  };
  ran_away = ran_away || outran(before) || outran(previous);
  previous = state;
}

bool LossOfControl::Run::carried_on() const {
  if (!finding || !under_load || ran_away) return false;
  const double q_before = std::fabs(before.q);
  const bool grew =
      last >= (1 + limits::kGrowth) * q_before || load >= (1 + limits::kGrowth) * first_load;
  const bool long_enough = readings > kCalm || grew;
  const bool shed = min_load <= (1 - limits::kGrowth) * first_load;
  return long_enough && !shed && least > (1 - limits::kGrowth) * q_before && last >= q_before;
}

Finding LossOfControl::Run::final_finding() const {
  Finding result = *finding;
  if (carried_on()) {
    result.detected = false;
    result.evidence +=
        fmt::format("; q increased further to {:.2f} kPa, no strength was lost", last / 1e3);
  } else if (loss && loss->came_back()) {
    result.evidence += fmt::format("; q fell to {:.2f} kPa and recovered to {:.2f} kPa",
                                   loss->least() / 1e3, loss->largest_since() / 1e3);
  }
  return result;
}

/// Of two the one that is not made good, else the first.
const LossOfControl::Run* LossOfControl::decisive() const {
  const bool both = run_.lost() && earlier_.lost();
  if (both) return run_.loss->came_back() ? &earlier_ : &run_;
  if (run_.lost()) return &run_;
  return earlier_.lost() ? &earlier_ : nullptr;
}

std::optional<Finding> LossOfControl::finding() const {
  if (const Run* run = decisive()) return run->final_finding();
  if (run_.finding) return run_.final_finding();
  return earlier_.finding ? earlier_.final_finding() : step_;
}

std::optional<Finding> LossOfControl::lost() const {
  const Run* run = decisive();
  return run ? std::optional(run->final_finding()) : std::nullopt;
}

const LossAndReturn* LossOfControl::loss() const {
  const Run* run = decisive();
  return run && run->loss ? &*run->loss : nullptr;
}

std::string LossOfControl::blind() const {
  return looked_ ? std::string()
                 : "not applied: a displacement was prescribed, and a frame cannot lose control";
}

void LossOfControl::check_held_q(const State& state, bool has_time) {
  const double q = std::fabs(state.q);  // in extension as in compression
  if (std::isnan(q)) return;
  if (held_count_ < kReference) {
    const double change = q - q_mean_;
    q_mean_ += change / ++held_count_;
    q_square_ += change * (q - q_mean_);
    return;
  }
  const double deviation = std::sqrt(q_square_ / (kReference - 1));
  if (q > q_mean_ - std::max(limits::kGrowth * q_mean_, 6 * deviation)) {
    below_ = 0;
    return;
  }
  if (below_++ == 0) first_below_ = state;
  if (below_ < 3) return;
  begin(first_below_,
        fmt::format("q was held at {:.2f} ± {:.2f} kPa and fell to {:.2f} kPa", q_mean_ / 1e3,
                    deviation / 1e3, q / 1e3),
        has_time);
}

/// Rise of the pore pressure beyond what the programme asks; unknown (NaN) without pore pressure.
double LossOfControl::pore_excess(const State& from, const State& to) const {
  const double rise = to.pore_pressure - from.pore_pressure;
  const double of_cell = rise + to.effective_stress.radial - from.effective_stress.radial;
  return rise - (drainage_ == Drainage::closed ? of_cell : std::fmax(of_cell, 0.0));
}

void LossOfControl::check_bursts(const State& state, bool has_time) {
  // recent_ holds the last few states, oldest first; what leaves it becomes the rate so far.
  if (count_ > kRecent) {
    const double weight = 1.0 / static_cast<double>(std::min<std::int64_t>(++steps_, 64));
    const double dt = lapse(recent_[0], recent_[1], has_time);
    const auto learn = [&](double& mean, double change) {
      if (!std::isnan(change)) mean += weight * (std::fabs(change) / dt - mean);
    };
    const double step = recent_[1].strain.axial - recent_[0].strain.axial;
    learn(mean_rate_, step);
    largest_rate_ = std::max(largest_rate_, std::fabs(step) / dt);
    learn(mean_pore_rate_, pore_excess(recent_[0], recent_[1]));
  }
  std::shift_left(recent_.begin(), recent_.end(), 1);
  recent_.back() = state;
  if (steps_ < kReference) return;
  if (!run_.finding) check_strain_burst(has_time);
  const bool knows_pore = control_ != AxialControl::unknown && whole_ >= kRecent;
  if (!run_.finding && knows_pore) check_pore_burst(has_time);
}

/// A displacement that was set to zero between two stages leaps too, but q does not.
void LossOfControl::check_leap(const State& before, const State& state, bool has_time) {
  const bool next = state.reading == before.reading + 1;
  const double leap = std::fabs(state.strain.axial - before.strain.axial);
  // Pulled on, it sheds the load with its area at a q that stays.
  const bool pulled = state.q < 0 && state.strain.axial < before.strain.axial;
  const bool onward = state.q > 0 && state.strain.axial > before.strain.axial;
  const double left = pulled ? carried_load(state) / carried_load(before) : state.q / before.q;
  if (!next || !(leap >= limits::kLeap)) return;
  const auto jumped = [&](const char* what) {
    return fmt::format(
        "axial strain jumped from {:.3f} % to {:.3f} % between two readings, and {} from {:.2f} "
        "kPa to {:.2f} kPa",
        before.strain.axial * 100, state.strain.axial * 100, what, before.q / 1e3, state.q / 1e3);
  };
  const bool falls_with_its_area = onward && left < 1 - leap / 2 && left > 1 - 2 * leap;
  if (std::fabs(left) < 1 - limits::kGrowth || falls_with_its_area)
    begin(before, jumped(pulled ? "the load fell, with q" : "q fell"), has_time);
  else if ((onward || pulled) && left >= 1 + limits::kGrowth && !step_)
    step_ = Finding{.instant = instant_of(before, has_time),
                    .evidence = jumped("q grew, with a step of the load,"),
                    .detected = bursts_open(before, state)};
}

/// The pore pressure leapt although the valve is open: the specimen ran, the step set it going.
bool LossOfControl::bursts_open(const State& before, const State& state) const {
  return drainage_ == Drainage::open && whole_ > 0 &&
         pore_excess(before, state) > limits::kBurstPressure * before.p_eff;
}

/// The latest step against the fastest before it, and the q that was lost with it.
bool LossOfControl::outruns_any_frame(bool has_time) const {
  const State &before = recent_[kRecent - 2], &last = recent_.back();
  const double step =
      std::fabs(last.strain.axial - before.strain.axial) / lapse(before, last, has_time);
  return step > limits::kBurst * largest_rate_ &&
         std::fabs(last.q) < (1 - limits::kGrowth) * std::fabs(before.q);
}

void LossOfControl::check_strain_burst(bool has_time) {
  constexpr double kCreep = 0.1;  ///< of the fastest step
  const State& last = recent_.back();
  const auto rate = [&](const State& a, const State& b) {
    return std::fabs(b.strain.axial - a.strain.axial) / lapse(a, b, has_time);
  };
  const double rise = std::fabs(last.strain.axial - recent_.front().strain.axial);
  const double burst = rate(recent_.front(), last);
  if (rise < limits::kBurstStrain || burst < limits::kBurst * mean_rate_) return;
  if (control_ == AxialControl::unknown && !outruns_any_frame(has_time)) return;
  // The burst began where the steps first left what they had been. What crept faster before a
  // specimen fell within one interval is not yet the fall.
  double fastest = 0;
  for (std::size_t i = 0; i + 1 < recent_.size(); ++i)
    fastest = std::max(fastest, rate(recent_[i], recent_[i + 1]));
  const double least = std::max(limits::kBurst / 2 * mean_rate_, kCreep * fastest);
  std::size_t start = 0;
  while (start + 2 < recent_.size() && rate(recent_[start], recent_[start + 1]) < least) ++start;
  if (std::fabs(last.strain.axial - recent_[kRecent - 2].strain.axial) >= limits::kLeap)
    run_.fall = Fall{recent_[start], last};
  begin(recent_[start],
        fmt::format("axial strain increased from {:.3f} % to {:.3f} % within {}{}",
                    recent_[start].strain.axial * 100, last.strain.axial * 100,
                    in_readings(kRecent - 1 - start),
                    mean_rate_ > 0
                        ? fmt::format(", {:.0f} times faster than before", burst / mean_rate_)
                        : ", without movement before"),
        has_time);
}

void LossOfControl::check_pore_burst(bool has_time) {
  const State &first = recent_.front(), &last = recent_.back();
  const double excess = pore_excess(first, last);
  const double burst = excess / lapse(first, last, has_time);
  if (!(excess > limits::kBurstPressure * first.p_eff) || burst < limits::kBurst * mean_pore_rate_)
    return;
  std::size_t start = 0;
  while (start + 2 < recent_.size() && pore_excess(recent_[start], recent_[start + 1]) <
                                           limits::kBurst / 2 * mean_pore_rate_ *
                                               lapse(recent_[start], recent_[start + 1], has_time))
    ++start;
  begin(recent_[start],
        fmt::format("pore pressure increased from {:.2f} kPa to {:.2f} kPa within {} readings, "
                    "{:.2f} kPa more than prescribed",
                    recent_[start].pore_pressure / 1e3, last.pore_pressure / 1e3,
                    static_cast<std::int64_t>(kRecent - 1 - start),
                    pore_excess(recent_[start], last) / 1e3),
        has_time);
}

}  // namespace triax::lab
