// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/path_runner.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/point/segment_witnesses.hpp"

namespace triax::sim {
namespace {

constexpr std::size_t kMostWarnings = 50;
/// Share of the stress at the start at which nothing is left of it.
constexpr double kVanishedStress = 1e-6;
constexpr const char* kLostMessage = "the condition cannot be maintained";
constexpr const char* kVanishedMessage =
    "the effective stress has vanished, and the law carries no tension";
/// Share of the mean stress that a deviator stress of round-off may have.
constexpr double kNoDeviator = 1e-9;
/// A strain of which small-strain theory says nothing.
constexpr double kLargeStrain = 1;

/// Two messages that differ in their numbers only say the same.
std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return text;
}

template <class Space>
class Runner {
 public:
  Runner(const Law<Space>& law, const Path<Space>& path, const PathOptions& options)
      : law_(law), path_(path), options_(options), order_(segment_order(path)) {
    for (const auto& segment : path.segments) {
      controls_.push_back(effective_control(segment));
      if (segment.rows < 1) throw std::invalid_argument("a segment needs at least one row");
    }
    now_.state = law.start(path.stress, path.void_ratio);
    const auto wanted = static_cast<std::size_t>(now_.state.memory.size());
    if (!path.memory.empty() && path.memory.size() != wanted)
      throw std::invalid_argument("the law has " + std::to_string(wanted) +
                                  " values of memory, not " + std::to_string(path.memory.size()));
    for (std::size_t i = 0; i < path.memory.size(); ++i)
      now_.state.memory(static_cast<Eigen::Index>(i)) = path.memory[i];
    now_.pore_pressure = path.pore_pressure;
  }

  PathResult<Space> run() {
    if (auto objection = law_.objection(now_.state)) {
      fail("the start: " + *objection);
    } else {
      note_warning();
      double total = 0, before = 0;
      for (const std::size_t i : order_) total += parts_of(path_.segments[i]);
      for (std::size_t k = 0; k < order_.size() && going_; ++k) {
        segment_ = order_[k];
        ended_ = ended_ && segment().goes_on;
        if (!ended_) run_segment(k == 0, before, total);
        before += parts_of(path_.segments[segment_]);
      }
      if (going_ && result_.outcome == StepOutcome::inaccurate)
        result_.message = "the integration error exceeds the tolerance";
    }
    result_.last = point(now_);
    if (order_.empty() || result_.rows.empty()) result_.rows.push_back(result_.last);
    note_peak(now_);
    return std::move(result_);
  }

 private:
  using Instant = PathInstant<Space>;

  const Segment<Space>& segment() const { return path_.segments[segment_]; }
  const EffectiveControl<Space>& effective() const { return controls_[segment_]; }

  void fail(const std::string& message) {
    going_ = false;
    result_.outcome = StepOutcome::failed;
    result_.message = message;
  }

  void run_segment(bool first, double before, double total) {
    const SegmentParts<Space> parts(law_, segment(), effective(), options_.tolerance);
    SegmentWitnesses<Space> witnesses(parts);
    now_.progress = now_.fraction = 0;
    now_.rate = parts.rate_at(now_.state);
    if (first) {
      result_.rows.push_back(point(now_));
      note_peak(now_);
    }
    if (note_start(witnesses.at_start(now_))) return end_by_condition();
    const int per_row = parts.count() / segment().rows;
    for (int i = 0; i < parts.count() && going_; ++i) {
      if (options_.progress && !options_.progress((before + i) / total)) {
        fail("stopped");
        break;
      }
      if (!take_part(parts, witnesses, i)) return;
      if ((i + 1) % per_row == 0) result_.rows.push_back(point(now_));
    }
  }

  /// The part number i; false where the segment ends within it.
  bool take_part(const SegmentParts<Space>& parts, SegmentWitnesses<Space>& witnesses, int i) {
    const Instant from = now_;
    const PointStep<Space> step = parts.step(from, 1);
    result_.error = std::max(result_.error, step.error);
    const bool whole =
        step.outcome == StepOutcome::accepted || step.outcome == StepOutcome::inaccurate;
    if (step.outcome == StepOutcome::inaccurate) result_.outcome = StepOutcome::inaccurate;
    Instant to = parts.instant(from, step, whole ? 1 : step.done);
    if (whole) to.progress = static_cast<double>(i + 1) / parts.count();
    if (note_events(witnesses.between(from, to))) {
      end_by_condition();
      return false;
    }
    work_is_negative_ = witnesses.work_is_negative();
    now_ = to;
    note_peak(now_);
    note_warning();
    if (whole) return true;
    stop(parts, from, step);
    return false;
  }

  /// True where an end condition was met before anything was done.
  bool note_start(const std::vector<WitnessedEvent<Space>>& events) {
    bool met = false;
    for (const auto& event : events) {
      met = met || event.kind == PathEventKind::end_condition;
      // A segment that goes on with the negative work of the one before tells nothing new.
      if (event.kind != PathEventKind::second_order_work || !work_is_negative_) note_event(event);
    }
    return met;
  }

  /// True, with `now_` there, where one of the events ends the segment; the later ones are not
  /// reached.
  bool note_events(const std::vector<WitnessedEvent<Space>>& events) {
    for (const auto& event : events) {  // NOLINT(readability-use-anyofallof): each is noted
      note_event(event);
      if (event.kind != PathEventKind::end_condition) continue;
      now_ = event.at;
      return true;
    }
    return false;
  }

  void end_by_condition() {
    ended_ = true;
    end_early();
  }

  void end_early() {
    const auto row = point(now_);
    if (result_.rows.empty() || result_.rows.back().segment != row.segment ||
        result_.rows.back().progress != row.progress)
      result_.rows.push_back(row);
    note_peak(now_);
  }

  void stop(const SegmentParts<Space>& parts, const Instant& from, const PointStep<Space>& step) {
    going_ = false;
    result_.outcome = step.outcome;
    result_.message = step.message;
    const bool vanished =
        !law_.carries_tension() &&
        step.state.p() < kVanishedStress * std::max(mean_stress<Space>(path_.stress), 1e3);
    if (step.outcome == StepOutcome::lost_control) result_.message = kLostMessage;
    if (vanished) result_.message = kVanishedMessage;
    if (step.outcome == StepOutcome::lost_control && step.limiting_variable >= 0) {
      // Without stress any strain could be held: what is at an end is the material.
      if (vanished && effective().control.stress.row(step.limiting_variable).isZero(0))
        result_.outcome = StepOutcome::failed;
      else
        lose_control(effective().labels[static_cast<std::size_t>(step.limiting_variable)]);
    }
    end_early();
    FailedIncrement<Space> failed{point(from), segment()};
    failed.segment.conditions.increment /= parts.count();
    failed.segment.rows = failed.segment.least_parts = failed.segment.repeat = 1;
    failed.segment.repeat_from.reset();
    failed.segment.end.clear();
    result_.failed = std::move(failed);
  }

  void lose_control(const std::string& limiting_variable) {
    result_.limiting_variable = limiting_variable;
    PathPoint<Space> at = point(now_);
    at.determinant = 0;
    result_.events.push_back({PathEventKind::control_limit, limiting_variable, at});
  }

  void note_event(const WitnessedEvent<Space>& event) {
    if (event.kind == PathEventKind::second_order_work) work_is_negative_ = true;
    result_.events.push_back({event.kind, event.what, point(event.at)});
    note_peak(event.at);
  }

  void note_peak(const Instant& at) {
    largest_p_ = std::max(largest_p_, std::abs(at.state.p()));
    const double q = std::abs(at.state.q());
    if (q <= kNoDeviator * largest_p_ || q <= peak_q_ * (1 + 1e-12)) return;
    peak_q_ = q;
    result_.peak = point(at);
  }

  void note_warning() {
    if (const auto text = law_.warning(now_.state)) warn(*text);
    if (now_.strain.norm() > kLargeStrain)
      warn("strains above 100 %: beyond the range of small strains");
  }

  void warn(const std::string& text) {
    if (result_.warnings.size() >= kMostWarnings) return;
    const std::string key = without_numbers(text);
    if (std::ranges::find(warned_, key) != warned_.end()) return;
    warned_.push_back(key);
    result_.warnings.push_back(text);
  }

  PathPoint<Space> point(const Instant& at) const {
    PathPoint<Space> p;
    p.segment = segment_;
    p.progress = at.progress;
    p.stress = at.state.stress;
    p.strain = at.strain;
    p.void_ratio = at.state.void_ratio;
    p.pore_pressure = at.pore_pressure;
    p.memory.assign(at.state.memory.begin(), at.state.memory.end());
    if (!at.rate.controllable) return p;
    p.determinant = at.rate.determinant;
    if (at.rate.stress.norm() * at.rate.strain.norm() > 0)
      p.second_order_work = at.rate.normalised_work();
    return p;
  }

  const Law<Space>& law_;
  const Path<Space>& path_;
  const PathOptions& options_;
  const std::vector<std::size_t> order_;
  std::vector<EffectiveControl<Space>> controls_;
  PathResult<Space> result_;
  Instant now_;
  std::size_t segment_ = 0;
  double peak_q_ = 0;
  double largest_p_ = 0;
  std::vector<std::string> warned_;
  bool going_ = true;
  bool ended_ = false;  ///< the segment before was, by a condition
  bool work_is_negative_ = false;
};

}  // namespace

template <class Space>
PathResult<Space> run_path(const Law<Space>& law, const Path<Space>& path,
                           const PathOptions& options) {
  return Runner<Space>(law, path, options).run();
}

template PathResult<Axisymmetric> run_path(const Law<Axisymmetric>&, const Path<Axisymmetric>&,
                                           const PathOptions&);
template PathResult<Tensor> run_path(const Law<Tensor>&, const Path<Tensor>&, const PathOptions&);

}  // namespace triax::sim
