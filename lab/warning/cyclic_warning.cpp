// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/warning/cyclic_warning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/cycles.hpp"
#include "lab/warning/warning_limits.hpp"

namespace triax::lab {
namespace {

using Sample = LoadBranch::Sample;
namespace limits = warning_limits;

constexpr double kMinRange = 0.02;     ///< of a load that turns, of p′₀
constexpr double kTurn = 0.1;          ///< of the range of q, by which it comes back
constexpr double kSamePhase = 0.02;    ///< of the range, that a partner may miss
constexpr double kOuter = 0.8;         ///< of q_a, from which q is near an end of the load
constexpr double kMinPressure = 0.05;  ///< of p′₀
constexpr double kMinGrowth = 0.003;   ///< of |s|
constexpr double kWorkFloor = 0.02;    ///< of q_a ε_r
constexpr double kMaxWorkRatio = 0.5, kMaxWorkGrowth = 2;  ///< logarithms
constexpr double kNoPartner = 0.2;    ///< work ratio and shift in the first cycle
constexpr std::size_t kBranches = 4;  ///< two cycles
constexpr int kTurnsOfCycle = 2, kTurnsUncounted = 3;

/// bench/recorded/fit_cyclic.py prints them.
constexpr double kConstant = 33.92;
constexpr CyclicWarning::Numbers kFactors{11.56, 12.96, 4.576, 9.256};

double larger(double a, double b) { return std::fmax(a, b); }  // NaN: the other

Sample merge(const Sample& a, Sample b) {
  b.growth = larger(a.growth, b.growth);
  b.shift = larger(a.shift, b.shift);
  return b;
}

double sign_of(double q) { return q > 0 ? 1 : -1; }
std::size_t side_of(double q) { return q > 0 ? 1 : 0; }

}  // namespace

void LoadBranch::add(const Sample& sample) {
  if (count_++ % stride_ != 0)
    samples_.back() = merge(samples_.back(), sample);
  else
    samples_.push_back(sample);
  if (samples_.size() < kMaxSamples || count_ % stride_ != 0) return;
  for (std::size_t i = 0; i < kMaxSamples / 2; ++i)
    samples_[i] = merge(samples_[2 * i], samples_[2 * i + 1]);
  samples_.resize(kMaxSamples / 2);
  stride_ *= 2;
}

std::size_t LoadBranch::index_at(double q) const {
  const auto beyond = [&](const Sample& sample) { return direction_ * (sample.q - q) >= 0; };
  return static_cast<std::size_t>(std::ranges::find_if(samples_, beyond) - samples_.begin());
}

std::optional<Sample> LoadBranch::at(double q, double tolerance) const {
  if (samples_.empty() || direction_ * (samples_.front().q - q) > tolerance ||
      direction_ * (q - samples_.back().q) > tolerance)
    return std::nullopt;
  const std::size_t i = index_at(q);
  if (i == 0) return samples_.front();
  if (i == samples_.size()) return samples_.back();
  const Sample &a = samples_[i - 1], &b = samples_[i];
  const double f = (q - a.q) / (b.q - a.q);
  return Sample{.q = q,
                .strain = std::lerp(a.strain, b.strain, f),
                .work = std::lerp(a.work, b.work, f),
                .s = std::lerp(a.s, b.s, f)};
}

double CyclicWarning::sine(double q, double p_eff) const {
  const double eta = q / std::max(p_eff, kMinPressure * first_->p_eff);
  return 3 * eta / (6 + eta);
}

double CyclicWarning::min_range() const {
  return std::max(kMinRange * first_->p_eff, assessment_limits::kNoise * noise_.value());
}

double CyclicWarning::range() const {
  if (ends_[0] && ends_[1]) return *ends_[1] - *ends_[0];
  return std::max(high_ - low_, min_range());
}

double CyclicWarning::middle() const {
  return (ends_[0].value_or(low_) + ends_[1].value_or(high_)) / 2;
}

/// Of the test, or after an interruption.
void CyclicWarning::begin(const State& state) {
  if (!first_) first_ = state;
  counts_cycles_ = std::isfinite(state.cycle);
  latest_ = state;
  direction_ = 0;
  low_ = high_ = start_q_ = state.q;
  anchor_ = {state.q, has_time_ ? state.time_s : count_};
}

bool CyclicWarning::add(const State& state) {
  if (!latest_) begin(state);
  const double at = has_time_ ? state.time_s : count_++;
  load_was_carried_ = false;
  noise_.add(state.q);
  low_ = std::min(low_, state.q);
  high_ = std::max(high_, state.q);
  work_ += (state.q + latest_->q) / 2 * (state.strain.axial - latest_->strain.axial);
  latest_ = state;
  if (rests(state.q, at)) start_again(Restart::rest);
  follow(
      {.q = state.q, .strain = state.strain.axial, .work = work_, .s = sine(state.q, state.p_eff)},
      at);
  numbers_ = describe_cycle();
  if (!numbers_) return false;
  probability_ = probability(*numbers_);
  const bool withdraws = load_was_carried_ && probability_ < limits::kWithdraw;
  return std::exchange(is_imminent_, is_imminent_ ? !withdraws : probability_ >= limits::kIssue) !=
         is_imminent_;
}

/// Longer than the last cycle.
bool CyclicWarning::rests(double q, double at) {
  const bool moved = std::fabs(q - anchor_.q) > limits::kResting * range();
  const bool rests = !moved && turn_times_.size() == kTurnsUncounted &&
                     at - anchor_.at > turn_times_.back() - turn_times_.front();
  if (moved || rests) anchor_ = {q, at};
  return rests;
}

void CyclicWarning::follow(Sample sample, double at) {
  if (direction_ == 0) {
    const double moved = sample.q - start_q_;
    if (std::fabs(moved) > min_range()) direction_ = moved > 0 ? 1 : -1;
    current_.set_direction(direction_);
    compare(sample);
    current_.add(sample);
    extreme_ = {sample.q, at};
  } else if (direction_ * (sample.q - extreme_.q) >= 0) {
    extend(sample, at);
  } else {
    if (!behind_) behind_.emplace(-direction_);
    behind_->add(sample);
    const double back = direction_ * (extreme_.q - sample.q);
    if (back > std::max(min_range(), kTurn * range())) turn(sample, at);
  }
}

/// The half cycle goes on. Readings that seemed to be past its end belong to it.
void CyclicWarning::extend(Sample sample, double at) {
  if (behind_)
    for (const Sample& passed : behind_->samples()) current_.add(passed);
  behind_.reset();
  compare(sample);
  current_.add(sample);
  extreme_ = {sample.q, at};
  auto& last = end(direction_);
  if (!last || direction_ * (sample.q - *last) <= limits::kChangedEnd * range()) return;
  start_again(Restart::larger_load);
  last.reset();
}

void CyclicWarning::turn(const Sample& sample, double at) {
  auto& last = end(direction_);
  load_was_carried_ = !last || direction_ * (*last - extreme_.q) <= limits::kChangedEnd * range();
  if (!load_was_carried_) start_again(Restart::smaller_load);
  last = extreme_.q;
  ++turns_;
  turn_times_.push_back(extreme_.at);
  if (turn_times_.size() > kTurnsUncounted) turn_times_.erase(turn_times_.begin());
  earlier_.insert(earlier_.begin(), std::exchange(current_, *std::exchange(behind_, std::nullopt)));
  if (earlier_.size() > 1) keep_reached(earlier_[1]);
  if (turns_ == kTurnsOfCycle && is_loaded_first()) {
    has_virtual_cycle_ = false;
    earlier_.resize(1);
  }
  if (earlier_.size() > kBranches) earlier_.pop_back();
  direction_ = -direction_;
  for (Sample& passed : current_.samples()) compare(passed);
  extreme_ = {sample.q, at};
}

void CyclicWarning::interrupt() {
  if (!first_) return;
  behind_.reset();
  start_again(Restart::interruption);
  current_ = LoadBranch(direction_);
  ends_ = {};
  turn_times_.clear();
  latest_.reset();
  numbers_.reset();
  is_imminent_ = false;
}

/// The first half cycle began outside the load: it is no part of the cycles.
bool CyclicWarning::is_loaded_first() const {
  return std::fabs(start_q_ - middle()) > (0.5 + limits::kChangedEnd) * range();
}

/// The load of a rest is as it was: the work of the first cycle stays a measure.
void CyclicWarning::start_again(Restart why) {
  restart_ = why;
  restarted_at_ = cycles();
  has_virtual_cycle_ = false;
  if (!earlier_.empty()) keep_reached(earlier_.front());
  keep_reached(current_);
  earlier_.clear();
  if (why != Restart::rest) first_work_.reset();
  LoadBranch begun(direction_);
  if (!current_.samples().empty()) begun.add(current_.samples().back());
  current_ = std::move(begun);
}

void CyclicWarning::keep_reached(const LoadBranch& branch) {
  for (const Sample& sample : branch.samples()) {
    double& reached = reached_[side_of(sample.q)];
    reached = std::max(reached, std::fabs(sample.s));
  }
}

void CyclicWarning::compare(Sample& sample) const {
  if (earlier_.size() > 1) {
    if (const auto before = earlier_[1].at(sample.q, kSamePhase * range())) {
      const double growth = sign_of(sample.q) * (sample.s - before->s);
      sample.growth = std::min(growth, std::fabs(sample.s) - reached_[side_of(sample.q)]);
      sample.shift = std::fabs(sample.strain - before->strain);
      return;
    }
  }
  if (has_virtual_cycle_ && earlier_.size() < kTurnsUncounted)
    sample.growth = sign_of(sample.q) * (sample.s - sine(sample.q, first_->p_eff));
}

/// Up to the latest reading: this half cycle, the one before, and the rest of the one before that.
std::vector<const Sample*> CyclicWarning::latest_cycle() const {
  std::vector<const Sample*> cycle;
  const auto add = [&](const LoadBranch& branch, std::size_t from) {
    for (std::size_t i = from; i < branch.samples().size(); ++i)
      cycle.push_back(&branch.samples()[i]);
  };
  add(current_, 0);
  if (behind_) add(*behind_, 0);
  add(earlier_[0], 0);
  if (earlier_.size() > 1 && !behind_) add(earlier_[1], earlier_[1].index_at(latest_->q));
  return cycle;
}

std::optional<CyclicWarning::Work> CyclicWarning::work_of_cycle() const {
  const auto same_phase = [&](std::size_t index) -> std::optional<Sample> {
    if (earlier_.size() <= index) return std::nullopt;
    const LoadBranch& branch = earlier_[index];
    if (behind_) return branch.samples().back();
    const double q = latest_->q;
    // A load that falls short of its last end, or goes beyond it, is still in that phase.
    if (branch.index_at(q) == branch.samples().size()) return branch.samples().back();
    return branch.at(q, kSamePhase * range());
  };
  const auto between = [&](const Sample& from, double work, double strain) {
    return std::max(0.0, work - from.work - middle() * (strain - from.strain));
  };
  const auto start = same_phase(1);
  if (!start) return std::nullopt;
  Work found{.now = between(*start, work_, latest_->strain.axial), .before = {}};
  if (const auto before = same_phase(3))
    found.before = between(*before, start->work, start->strain);
  return found;
}

bool CyclicWarning::is_cyclic() const { return counts_cycles_ || earlier_.size() > kTurnsOfCycle; }

bool CyclicWarning::has_cycle_before() const {
  if (!has_virtual_cycle_) return earlier_.size() >= kTurnsUncounted;
  return turns_ >= (counts_cycles_ ? kTurnsOfCycle : kTurnsUncounted);
}

std::optional<CyclicWarning::Numbers> CyclicWarning::describe_cycle() {
  if (!has_cycle_before()) return std::nullopt;
  double growth = kMissing, shift = kMissing, low = latest_->strain.axial, high = low;
  for (const Sample* sample : latest_cycle()) {
    const double from_middle = std::fabs(sample->q - middle());
    if (from_middle > kOuter * range() / 2) growth = larger(growth, sample->growth);
    shift = larger(shift, sample->shift);
    low = std::min(low, sample->strain);
    high = std::max(high, sample->strain);
  }
  if (std::isnan(growth) || high <= low) return std::nullopt;
  const double floor = kWorkFloor * range() / 2 * (high - low);
  const auto ratio = [&](double work, double before, double most) {
    return std::clamp(std::log((work + floor) / (before + floor)), -1.0, most);
  };
  Numbers x{std::log(std::max(growth, kMinGrowth)), kNoPartner, 0, kNoPartner};
  const auto work = work_of_cycle();
  if (!work) return x;
  if (!first_work_) first_work_ = work->now;
  x[2] = ratio(work->now, *first_work_, kMaxWorkGrowth);
  if (!work->before) return x;
  x[1] = ratio(work->now, *work->before, kMaxWorkRatio);
  if (!std::isnan(shift)) x[3] = std::min(1.0, shift / (high - low));
  return x;
}

double CyclicWarning::probability(const Numbers& numbers) {
  double z = kConstant;
  for (std::size_t i = 0; i < kNumbers; ++i) z += kFactors[i] * numbers[i];
  return 1 / (1 + std::exp(-z));
}

std::string describe(CyclicWarning::Restart restart) {
  switch (restart) {
    case CyclicWarning::Restart::larger_load:
      return "the load became larger";
    case CyclicWarning::Restart::smaller_load:
      return "the load became smaller";
    case CyclicWarning::Restart::rest:
      return "the load was constant for longer than a cycle";
    case CyclicWarning::Restart::interruption:
      return "readings were interrupted";
    case CyclicWarning::Restart::none:
      break;
  }
  return "";
}

}  // namespace triax::lab
