// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/loss_of_control.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/measured/instant.hpp"

namespace triax::lab {
namespace {

std::string in_readings(std::size_t count) {
  return count == 1 ? "one reading" : fmt::format("{} readings", count);
}

constexpr double kBurst = 10;    ///< times the rate of the stage so far
constexpr double kFall = 0.01;   ///< axial strain between two readings
constexpr double kLostQ = 0.05;  ///< share of the q that was

/// Per second where there is time, so that a logger that slows down makes no burst; else per
/// reading.
double lapse(const State& from, const State& to, bool has_time) {
  return has_time ? to.time_s - from.time_s : static_cast<double>(to.reading - from.reading);
}

}  // namespace

void LossOfControl::start_stage(const StageInfo* stage) {
  const auto found = std::move(finding_);
  const auto fall = fall_;
  After after = after_;
  after.over = found.has_value();
  const State before = before_;
  const bool looked = looked_;
  const auto now = now_;
  *this = LossOfControl();
  looked_ = looked;
  now_ = now;
  finding_ = found;
  fall_ = fall;
  after_ = after;
  before_ = before;
  control_ = stage ? stage->control : AxialControl::unknown;
  drainage_ = stage ? stage->drainage : Drainage::unknown;
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
  const State before = std::exchange(before_, state);
  if (finding_) follow(state);
  if (control_ == AxialControl::displacement || finding_) return;
  looked_ = true;
  ++count_;
  if (control_ == AxialControl::constant_q) check_held_q(state, has_time);
  check_bursts(state, has_time);
  const bool carries_load = control_ != AxialControl::unknown;
  if (carries_load && steps_ < kReference && !finding_) check_leap(before, state, has_time);
  if (finding_) follow(state);
}

void LossOfControl::follow(const State& state) {
  if (after_.over || std::isnan(state.q)) return;
  const double q = std::fabs(state.q), before = std::fabs(finding_->instant.q_pa.value_or(0));
  if (after_.readings++ == 0) {
    after_.under_load = control_ == AxialControl::load;
    after_.least = q;
    after_.first_load = after_.least_load = carried_load(state);
  }
  after_.load = carried_load(state);
  after_.least_load = std::min(after_.least_load, after_.load);
  after_.least = std::min(after_.least, q);
  after_.last = q;
  if (!carried_on() || q < (1 + kLostQ) * before) return;
  finding_.reset();
  fall_.reset();
  after_ = {};
  // The rates of this stage are others now: they are learned anew.
  count_ = steps_ = 0;
  held_count_ = 0;
  largest_rate_ = mean_rate_ = mean_pore_rate_ = 0;
}

/// The force beyond that of the cell pressure, on a cross-section of one when shear began.
double LossOfControl::carried_load(const State& state) {
  return std::fabs(state.q) * (1 - volumetric_strain(state.strain)) / (1 - state.strain.axial);
}

bool LossOfControl::carried_on() const {
  const double before = std::fabs(finding_->instant.q_pa.value_or(0));
  const bool grew =
      after_.last >= (1 + kLostQ) * before || after_.load >= (1 + kLostQ) * after_.first_load;
  const bool long_enough = after_.readings > kCalm || grew;
  const bool shed = after_.least_load <= (1 - kLostQ) * after_.first_load;
  return after_.under_load && long_enough && !shed && after_.least > (1 - kLostQ) * before &&
         after_.last >= before;
}

std::optional<Finding> LossOfControl::finding() const {
  if (!finding_ || !carried_on()) return finding_;
  Finding told = *finding_;
  told.detected = false;
  told.evidence += fmt::format("; q went on to {:.2f} kPa, nothing was lost", after_.last / 1e3);
  return told;
}

std::string LossOfControl::blind() const {
  return looked_ ? std::string()
                 : "not looked for: a displacement was prescribed, and a frame keeps its control";
}

std::optional<Finding> LossOfControl::lost() const {
  return finding_ && !carried_on() ? finding_ : std::nullopt;
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
  if (q > q_mean_ - std::max(kLostQ * q_mean_, 6 * deviation)) {
    below_ = 0;
    return;
  }
  if (below_++ == 0) first_below_ = state;
  if (below_ < 3) return;
  finding_ =
      Finding{.instant = instant_of(first_below_, has_time),
              .evidence = fmt::format("q was held at {:.2f} ± {:.2f} kPa and fell to {:.2f} kPa",
                                      q_mean_ / 1e3, deviation / 1e3, q / 1e3),
              .noticed = now_};
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
  if (!finding_) check_strain_burst(has_time);
  const bool knows_pore = control_ != AxialControl::unknown && whole_ >= kRecent;
  if (!finding_ && knows_pore) check_pore_burst(has_time);
}

/// A displacement that was set to zero between two stages leaps too, but q does not.
void LossOfControl::check_leap(const State& before, const State& state, bool has_time) {
  const bool next = state.reading == before.reading + 1;
  const double leap = std::fabs(state.strain.axial - before.strain.axial);
  // Pulled on, it sheds the load with its area at a q that stays.
  const bool pulled = state.q < 0 && state.strain.axial < before.strain.axial;
  const double left = pulled ? carried_load(state) / carried_load(before) : state.q / before.q;
  if (!next || !(leap >= kFall) || !(std::fabs(left) < 1 - kLostQ)) return;
  finding_ =
      Finding{.instant = instant_of(before, has_time),
              .evidence = fmt::format(
                  "axial strain jumped from {:.3f} % to {:.3f} % between two readings "
                  "and {} from {:.2f} kPa to {:.2f} kPa",
                  before.strain.axial * 100, state.strain.axial * 100,
                  pulled ? "the load fell, with q" : "q fell", before.q / 1e3, state.q / 1e3),
              .noticed = now_};
}

/// The latest step against the fastest before it, and the q that was lost with it.
bool LossOfControl::outruns_any_frame(bool has_time) const {
  const State &before = recent_[kRecent - 2], &last = recent_.back();
  const double step =
      std::fabs(last.strain.axial - before.strain.axial) / lapse(before, last, has_time);
  return step > kBurst * largest_rate_ && std::fabs(last.q) < (1 - kLostQ) * std::fabs(before.q);
}

void LossOfControl::check_strain_burst(bool has_time) {
  constexpr double kLeastRise = 1e-3;
  constexpr double kCreep = 0.01;  ///< of the fastest step
  const State& last = recent_.back();
  const auto rate = [&](const State& a, const State& b) {
    return std::fabs(b.strain.axial - a.strain.axial) / lapse(a, b, has_time);
  };
  const double rise = std::fabs(last.strain.axial - recent_.front().strain.axial);
  const double burst = rate(recent_.front(), last);
  if (rise < kLeastRise || burst < kBurst * mean_rate_) return;
  if (control_ == AxialControl::unknown && !outruns_any_frame(has_time)) return;
  // The burst began where the steps first left what they had been. What crept faster before a
  // specimen fell within one interval is not yet the fall.
  double fastest = 0;
  for (std::size_t i = 0; i + 1 < recent_.size(); ++i)
    fastest = std::max(fastest, rate(recent_[i], recent_[i + 1]));
  const double least = std::max(kBurst / 2 * mean_rate_, kCreep * fastest);
  std::size_t start = 0;
  while (start + 2 < recent_.size() && rate(recent_[start], recent_[start + 1]) < least) ++start;
  if (std::fabs(last.strain.axial - recent_[kRecent - 2].strain.axial) >= kFall)
    fall_ = Fall{recent_[start], last};
  finding_ = Finding{
      .instant = instant_of(recent_[start], has_time),
      .evidence = fmt::format(
          "axial strain rose from {:.3f} % to {:.3f} % within {}{}",
          recent_[start].strain.axial * 100, last.strain.axial * 100,
          in_readings(kRecent - 1 - start),
          mean_rate_ > 0 ? fmt::format(", {:.0f} times faster than before", burst / mean_rate_)
                         : ", with no movement before"),
      .noticed = now_};
}

void LossOfControl::check_pore_burst(bool has_time) {
  constexpr double kLeastShare = 0.05;  // of p'
  const State &first = recent_.front(), &last = recent_.back();
  const double excess = pore_excess(first, last);
  const double burst = excess / lapse(first, last, has_time);
  if (!(excess > kLeastShare * first.p_eff) || burst < kBurst * mean_pore_rate_) return;
  std::size_t start = 0;
  while (start + 2 < recent_.size() &&
         pore_excess(recent_[start], recent_[start + 1]) <
             kBurst / 2 * mean_pore_rate_ * lapse(recent_[start], recent_[start + 1], has_time))
    ++start;
  finding_ = Finding{
      .instant = instant_of(recent_[start], has_time),
      .evidence = fmt::format(
          "pore pressure rose from {:.2f} kPa to {:.2f} kPa within {} readings, "
          "{:.2f} kPa more than prescribed",
          recent_[start].pore_pressure / 1e3, last.pore_pressure / 1e3,
          static_cast<std::int64_t>(kRecent - 1 - start), pore_excess(recent_[start], last) / 1e3),
      .noticed = now_};
}

}  // namespace triax::lab
