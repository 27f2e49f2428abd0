#include "sim/point/path_runner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace triax::sim {
namespace {

/// Rates, as shares of their natural size, that count as zero: round-off of the control's solution.
constexpr double kNoRate = 1e-9;
/// An event is isolated to this share of a part of a segment.
constexpr double kIsolated = 1e-11;
constexpr std::size_t kMostWarnings = 50;
/// Share of the stress at the start at which nothing is left of it.
constexpr double kVanished = 1e-6;
/// A strain of which small-strain theory says nothing.
constexpr double kLargeStrain = 1;

/// Two messages that differ in their numbers only say the same.
std::string without_numbers(std::string text) {
  std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return text;
}

/// dq in the direction of |q|, over |dσ|.
template <class Space>
double growth_of_q(const Vector<Space>& stress, const Vector<Space>& rate) {
  const double norm = rate.norm();
  if (!(norm > 0)) return 0;
  if constexpr (Space::kSize == 2) {
    const double q = deviator_stress<Space>(stress);
    return (q > 0 ? 1 : q < 0 ? -1 : 0) * deviator_stress<Space>(rate) / norm;
  } else {
    const Vector<Space> s = deviator<Space>(stress);
    const double size = s.norm();
    return size > 0 ? s.dot(rate) / (size * norm) : 0;
  }
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
        if (!ended_) {
          enter_segment(k == 0);
          run_segment(before, total);
        }
        before += parts_of(path_.segments[segment_]);
      }
      if (going_ && result_.outcome == StepOutcome::inaccurate)
        result_.message = "the integration error exceeds the tolerance";
    }
    result_.last = point(now_);
    if (order_.empty() || result_.rows.empty()) result_.rows.push_back(result_.last);
    note_peak(now_);
    result_.peak = peak_;
    return std::move(result_);
  }

 private:
  /// The point at an instant within the present segment.
  struct Instant {
    PointState<Space> state;
    Vector<Space> strain = Vector<Space>::Zero();
    double pore_pressure = 0;
    double progress = 0;  ///< of the segment
    double fraction = 0;  ///< of the part
    PointRate<Space> rate;
  };

  /// A number whose fall through zero is an event.
  struct Witness {
    PathEventKind kind;
    std::string what;
    int index = -1;         ///< of the end condition or row; −1 of the peak: q
    double allowance = 0;   ///< what still counts as zero
    bool armed = false;     ///< it has been positive in this segment
    bool negative = false;  ///< it is
  };

  static int parts_of(const Segment<Space>& segment) {
    const int rows = segment.rows, least = std::max(segment.least_parts, 1);
    return rows * ((least + rows - 1) / rows);
  }

  const Segment<Space>& segment() const { return path_.segments[segment_]; }
  const EffectiveControl<Space>& effective() const { return controls_[segment_]; }

  void fail(const std::string& message) {
    going_ = false;
    result_.outcome = StepOutcome::failed;
    result_.message = message;
  }

  void enter_segment(bool first) {
    part_ = effective().control;
    parts_ = parts_of(segment());
    part_.increment /= parts_;
    now_.progress = now_.fraction = 0;
    now_.rate = rate_at(now_.state);
    if (first) result_.rows.push_back(point(now_));
    witnesses_.clear();
    for (std::size_t i = 0; i < segment().end.size(); ++i)
      witnesses_.push_back(
          {PathEventKind::end_condition, segment().end[i].label, static_cast<int>(i), 0});
    witnesses_.push_back({PathEventKind::second_order_work, "second-order work", -1, kNoRate});
    witnesses_.push_back({PathEventKind::peak, "q", -1, kNoRate});
    const MixedControl<Space>& given = segment().conditions;
    for (int row = 0; row < Space::kSize; ++row)
      if (!given.stress.row(row).isZero(0) && !given.strain.row(row).isZero(0))
        witnesses_.push_back({PathEventKind::peak,
                              "stress part of " + effective().labels[static_cast<std::size_t>(row)],
                              row, kNoRate});
  }

  void run_segment(double before, double total) {
    if (met_already()) return end_by_condition();
    const int per_row = parts_ / segment().rows;
    for (int i = 0; i < parts_ && going_; ++i) {
      if (options_.progress && !options_.progress((before + i) / total)) {
        fail("stopped");
        break;
      }
      const Instant from = now_;
      if (!take_part(from, i)) return;
      if ((i + 1) % per_row == 0) result_.rows.push_back(point(now_));
    }
  }

  /// The part number i; false where the segment ends within it.
  bool take_part(const Instant& from, int i) {
    if (part_.increment.isZero(0)) return take_standstill(from, i);
    const PointStep<Space> step = advance_point(law_, from.state, part_, options_.tolerance);
    result_.error = std::max(result_.error, step.error);
    const bool whole =
        step.outcome == StepOutcome::accepted || step.outcome == StepOutcome::inaccurate;
    if (step.outcome == StepOutcome::inaccurate) result_.outcome = StepOutcome::inaccurate;
    Instant to = instant(from, step, whole ? 1 : step.done);
    to.progress = whole ? static_cast<double>(i + 1) / parts_ : to.progress;
    const bool ended = look_for_events(from, to);
    if (ended) {
      end_by_condition();
      return false;
    }
    now_ = to;
    note_peak(now_);
    note_warning();
    if (whole) return true;
    stop(from, step);
    return false;
  }

  /// Nothing acts on the skeleton: only the pore pressure follows a total stress.
  bool take_standstill(const Instant& from, int i) {
    now_.progress = static_cast<double>(i + 1) / parts_;
    now_.pore_pressure += effective().pore_pressure / parts_;
    for (Witness& witness : witnesses_) {
      if (witness.kind != PathEventKind::end_condition || value(witness, now_) > 0) continue;
      const double before = value(witness, from), after = value(witness, now_);
      const double share = before > after ? std::clamp(before / (before - after), 0.0, 1.0) : 1;
      now_ = from;
      now_.progress += share / parts_;
      now_.pore_pressure += share * effective().pore_pressure / parts_;
      note_event(witness, now_);
      end_by_condition();
      return false;
    }
    return true;
  }

  Instant instant(const Instant& from, const PointStep<Space>& step, double fraction) {
    Instant at;
    at.state = step.state;
    at.strain = from.strain + step.strain_increment;
    at.pore_pressure = from.pore_pressure;
    if (effective().undrained)
      at.pore_pressure += effective().pore_pressure_change(fraction / parts_, step.stress_increment,
                                                           step.strain_increment);
    at.fraction = fraction;
    at.progress = from.progress + fraction / parts_;
    at.rate = rate_at(at.state);
    return at;
  }

  /// The instant after this share of the part that starts at `from`; empty where it cannot be had.
  std::optional<Instant> within(const Instant& from, double fraction) {
    MixedControl<Space> control = part_;
    control.increment *= fraction;
    const PointStep<Space> step = advance_point(law_, from.state, control, options_.tolerance);
    if (step.outcome != StepOutcome::accepted && step.outcome != StepOutcome::inaccurate)
      return std::nullopt;
    return instant(from, step, fraction);
  }

  PointRate<Space> rate_at(const PointState<Space>& state) const {
    if (part_.increment.isZero(0) || law_.objection(state)) return {};
    return point_rate(law_, state, part_);
  }

  double value(const Witness& witness, const Instant& at) const {
    if (witness.kind == PathEventKind::end_condition) {
      const PathEnd& end = segment().end[static_cast<std::size_t>(witness.index)];
      const auto quantity = value_of(end.quantity, end.component, bare_point(at));
      if (!quantity) return 1;
      return end.above ? *end.above - *quantity : *quantity - *end.below;
    }
    if (!at.rate.controllable) return 0;
    if (witness.kind == PathEventKind::second_order_work) return at.rate.normalised_work();
    if (witness.index < 0) return growth_of_q<Space>(at.state.stress, at.rate.stress);
    const auto row = segment().conditions.stress.row(witness.index);
    Vector<Space> rate = at.rate.stress;
    Vector<Space> stress = at.state.stress + at.pore_pressure * identity<Space>();
    if (effective().undrained)
      rate += effective().pore_pressure_change(1.0 / parts_, at.rate.stress, at.rate.strain) *
              identity<Space>();
    const double level = row.dot(stress), norm = row.norm() * rate.norm();
    return norm > 0 && level != 0 ? std::copysign(row.dot(rate) / norm, level * row.dot(rate)) : 0;
  }

  bool met_already() {
    bool met = false;
    for (Witness& witness : witnesses_) {
      const double at_start = value(witness, now_);
      witness.armed = at_start > witness.allowance;
      if (witness.kind == PathEventKind::end_condition && at_start <= 0) {
        note_event(witness, now_);
        met = true;
      } else if (witness.kind == PathEventKind::second_order_work &&
                 at_start < -witness.allowance) {
        witness.negative = true;
        if (!work_is_negative_) note_event(witness, now_);
      }
    }
    return met;
  }

  /// Isolates what happened between two instants; true, with `now_` there, if the segment ended.
  bool look_for_events(const Instant& from, const Instant& to) {
    Instant last = to;
    // Where control was lost there is no rate; that of just before tells what led there.
    if (!to.rate.controllable && to.fraction > 0)
      if (auto before = within(from, to.fraction * (1 - 1e-6))) last.rate = before->rate;
    std::vector<std::pair<Instant, Witness*>> found;
    for (Witness& witness : witnesses_) {
      const double after = value(witness, last);
      if (after > witness.allowance) {
        witness.armed = true;
        witness.negative = false;
        continue;
      }
      const bool end = witness.kind == PathEventKind::end_condition;
      if (!end && (!(after < -witness.allowance) || witness.negative)) continue;
      const bool tells = witness.armed || witness.kind == PathEventKind::second_order_work;
      witness.armed = false;
      witness.negative = true;
      if (tells) found.emplace_back(isolate(witness, from, last), &witness);
    }
    std::ranges::stable_sort(found, {}, [](const auto& one) { return one.first.fraction; });
    for (const auto& [at, witness] : found) {
      note_event(*witness, at);
      if (witness->kind != PathEventKind::end_condition) continue;
      now_ = at;
      return true;
    }
    for (const Witness& witness : witnesses_)
      if (witness.kind == PathEventKind::second_order_work) work_is_negative_ = witness.negative;
    return false;
  }

  /// The zero of the witness between two instants, at or just beyond it: false position in the
  /// Illinois form, with a halving now and then for witnesses that jump.
  Instant isolate(const Witness& witness, const Instant& from, const Instant& to) {
    const double zero = value(witness, from) > 0 ? 0 : -witness.allowance;
    double low = 0, high = to.fraction;
    double at_low = value(witness, from) - zero, at_high = value(witness, to) - zero;
    Instant beyond = to;
    for (int i = 0; i < 100 && high - low > kIsolated; ++i) {
      const bool halve = i % 4 == 3 || !(at_low > 0) || !(at_high < 0);
      const double share = halve ? 0.5 : at_low / (at_low - at_high);
      double middle = low + share * (high - low);
      if (!(middle > low && middle < high)) middle = 0.5 * (low + high);
      const auto tried = within(from, middle);
      const double found = tried ? value(witness, *tried) - zero : 0;
      if (found > 0) {
        low = middle;
        at_low = found;
        at_high /= 2;
        continue;
      }
      high = middle;
      at_high = found;
      at_low /= 2;
      if (tried) beyond = *tried;
      if (found == 0) break;
    }
    return beyond;
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

  void stop(const Instant& from, const PointStep<Space>& step) {
    going_ = false;
    result_.outcome = step.outcome;
    result_.message = step.message;
    if (step.outcome == StepOutcome::failed && !law_.carries_tension() &&
        step.state.p() < kVanished * std::max(mean_stress<Space>(path_.stress), 1e3))
      result_.message = "the effective stress has vanished, and the law knows no tension";
    if (step.outcome == StepOutcome::lost_control && step.culprit >= 0) {
      result_.culprit = effective().labels[static_cast<std::size_t>(step.culprit)];
      PathPoint<Space> at = point(now_);
      at.determinant = 0;
      result_.events.push_back({PathEventKind::control_limit, result_.culprit, at});
    }
    end_early();
    FailedIncrement<Space> failed{point(from), segment()};
    failed.segment.conditions.increment /= parts_;
    failed.segment.rows = failed.segment.least_parts = failed.segment.repeat = 1;
    failed.segment.repeat_from.reset();
    failed.segment.end.clear();
    result_.failed = std::move(failed);
  }

  void note_event(const Witness& witness, const Instant& at) {
    if (witness.kind == PathEventKind::second_order_work) work_is_negative_ = true;
    result_.events.push_back({witness.kind, witness.what, point(at)});
    note_peak(at);
  }

  void note_peak(const Instant& at) {
    const double q = std::abs(at.state.q());
    if (q <= peak_q_ * (1 + 1e-12)) return;
    peak_q_ = q;
    peak_ = point(at);
  }

  void note_warning() {
    if (const auto text = law_.warning(now_.state)) warn(*text);
    if (now_.strain.norm() > kLargeStrain)
      warn("strains above 100 %: beyond what small strains can stand for");
  }

  void warn(const std::string& text) {
    if (result_.warnings.size() >= kMostWarnings) return;
    const std::string key = without_numbers(text);
    if (std::ranges::find(warned_, key) != warned_.end()) return;
    warned_.push_back(key);
    result_.warnings.push_back(text);
  }

  /// Without what only a reader of rows wants.
  PathPoint<Space> bare_point(const Instant& at) const {
    PathPoint<Space> p;
    p.segment = segment_;
    p.progress = at.progress;
    p.stress = at.state.stress;
    p.strain = at.strain;
    p.void_ratio = at.state.void_ratio;
    p.pore_pressure = at.pore_pressure;
    return p;
  }

  PathPoint<Space> point(const Instant& at) const {
    PathPoint<Space> p = bare_point(at);
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
  MixedControl<Space> part_;
  std::vector<Witness> witnesses_;
  double peak_q_ = -1;
  PathPoint<Space> peak_;
  std::vector<std::string> warned_;
  int parts_ = 1;
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
