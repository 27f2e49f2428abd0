// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/judged_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

#include "lab/health/sensor_limits.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/path_sampler.hpp"
#include "lab/results/test_type.hpp"

namespace triax::lab {
namespace {

/// Strains count from the first reading of shear.
bool counts_from_shear(Quantity q) {
  return q == Quantity::axial_displacement || q == Quantity::back_volume;
}

bool serves_the_state(Quantity q, const RecordHeader& header) {
  if (!header.is_raw()) return true;
  if (q == Quantity::back_pressure) return !header.has(Quantity::pore_pressure);
  return info(q).raw.in_state;
}

/// What the axis is moved by, and by how much. They also make q.
constexpr ChannelSet kLoad = channel_bit(Quantity::axial_force) |
                             channel_bit(Quantity::axial_displacement) |
                             channel_bit(Quantity::cell_pressure);

/// The state without the stresses that stand on a channel that cannot be believed.
State believed_state(const JudgedStates::Judged& judged) {
  State state = judged.state;
  if (judged.wrong & kLoad) state.q = state.p_eff = kMissing;
  return state;
}

double volume_of(const RecordHeader& header) {
  const double diameter = header.specimen.diameter_m.value_or(0);
  return std::numbers::pi / 4 * diameter * diameter * header.specimen.height_m.value_or(0);
}

bool begins_unloaded(const RecordHeader& header) {
  using enum TestType::Consolidation;
  const TestType* const type = find_test_type(header.programme);
  return header.is_raw() &&
         !(type && (type->consolidation == anisotropic || type->consolidation == k0));
}

}  // namespace

JudgedStates::JudgedStates(const RecordHeader& header)
    : header_(header),
      health_(header),
      volume_(header),
      drainage_(volume_of(header)),
      plausibility_(header.specimen, begins_unloaded(header)) {}

Reading believed(const JudgedStates::Judged& judged) {
  Reading reading = judged.reading;
  for (ChannelSet wrong = judged.wrong; wrong != 0; wrong &= wrong - 1)
    reading.si[static_cast<std::size_t>(std::countr_zero(wrong))] = kMissing;
  return reading;
}

State axis_of(const JudgedStates::Judged& judged) {
  State state = judged.state;
  if (judged.wrong & channel_bit(Quantity::back_volume))
    state.q = state.p_eff = state.volumetric_strain = kMissing;
  if (judged.wrong & channel_bit(Quantity::pore_pressure))
    state.p_eff = state.pore_pressure = kMissing;
  return state;
}

/// Some do not log a volume that stands still: the column then ends with the drainage being shut.
void JudgedStates::note_volume_gauge(const Reading& reading) {
  const bool absent = !reading.has(Quantity::back_volume);
  const bool rested = stage_ == reading.stage ? gauge_rests_ : !gauge_was_absent_;
  const StageInfo* info = header_.stage(reading.stage);
  gauge_rests_ = absent && rested && info && info->drainage == Drainage::closed;
  gauge_was_absent_ = absent;
  stage_ = reading.stage;
}

void JudgedStates::add(const Reading& reading, const State& state) {
  note_volume_gauge(reading);
  held_.emplace_back(reading, volume_.completed(state));
  health_.watch(reading);
  for (const auto& wrong : health_.wrong()) mark(wrong);
}

void JudgedStates::finish() {
  finished_ = true;
  health_.finish();
  for (const auto& wrong : health_.wrong()) mark(wrong);
}

bool JudgedStates::spoils(const SensorFinding& finding, int stage) const {
  if (!serves_the_state(finding.channel, header_)) return false;
  return !(finding.channel == Quantity::back_volume && finding.fault == SensorFault::missing &&
           gauge_rests_ && stage == stage_);
}

void JudgedStates::mark(const RecordHealth::Wrong& wrong) {
  if (is_vouched(wrong.finding, header_.vouched)) return;
  for (Judged& entry : held()) {
    if (entry.reading.number < wrong.from || entry.reading.number > wrong.until) continue;
    entry.wrong |= channel_bit(wrong.finding.channel);
    if (!spoils(wrong.finding, entry.reading.stage)) continue;
    if (entry.live) entry.reason = reason(wrong.finding);
    entry.live = false;
    entry.dead = entry.dead || wrong.finding.fault == SensorFault::stuck ||
                 wrong.finding.fault == SensorFault::saturated;
    entry.no_origin = entry.no_origin || counts_from_shear(wrong.finding.channel);
  }
  // A few readings that went in before they were known for a spike are no dead sensor.
  if (wrong.finding.fault == SensorFault::spike &&
      wrong.until - wrong.from < sensor_limits::kSpike.count())
    return;
  if (wrong.from > judged_last_ || !last_live_ || !spoils(wrong.finding, last_live_->stage)) return;
  axis_was_dead_ = axis_was_dead_ || (channel_bit(wrong.finding.channel) & kLoad) != 0;
  if (withheld_.empty())
    withheld_ = fmt::format("{} since reading {}", reason(wrong.finding), wrong.from);
}

/// A vector that is emptied keeps its memory; a deque would allocate for every reading.
void JudgedStates::drop_first() {
  ++first_;
  const bool is_last = first_ == held_.size();
  if (!is_last && first_ <= kHeld) return;
  held_.erase(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(first_));
  first_ = 0;
}

const JudgedStates::Judged* JudgedStates::next() {
  if (std::exchange(taken_, false)) drop_first();
  if (finished_ && held_.empty()) end_undrained(drainage_.suspicion());
  if (held_.empty()) return nullptr;
  Judged& entry = held_[first_];
  const bool full = static_cast<std::int64_t>(held().size()) > kHeld;
  if (!finished_ && !full && entry.reading.number >= health_.doubtful_from()) return nullptr;
  judge(entry);
  entry.axis_live = shows_axis(entry);
  taken_ = true;
  return &entry;
}

/// Across a stretch without readings: less than what counts as a collapse. The limit of q is used
/// for p′, which q follows.
bool JudgedStates::may_go_on(const State& state) const {
  return last_live_ &&
         std::fabs(state.q - last_live_->q) <
             assessment_limits::kLossOfStrength * std::fabs(last_live_->q) &&
         std::fabs(state.p_eff - last_live_->p_eff) <
             assessment_limits::kLossOfStrength * last_live_->p_eff &&
         std::fabs(state.strain.axial - last_live_->strain.axial) < assessment_limits::kHeldStrain;
}

/// False where the verdict has to end before this state.
bool JudgedStates::watch_drainage(Judged& entry, const StageInfo* stage) {
  if (!header_.is_raw() || !stage) return true;
  if (stage->drainage == Drainage::open) {
    end_undrained(drainage_.suspicion());
    drainage_.open();
  }
  if (stage->drainage != Drainage::closed || !is_watched(stage)) return true;
  drainage_was_said_ = stage->drainage_was_said;
  drainage_.add(believed(entry), believed_state(entry));
  entry.mark = drainage_.is_mark();
  end_undrained(drainage_.doubt());
  return drainage_was_said_ || !(drainage_.doubt() || drainage_.wet());
}

/// The specimen was drained after all: of two ends the earlier stands.
void JudgedStates::end_undrained(const std::optional<ClosedDrainage::Doubt>& doubt) {
  if (!doubt) return;
  if (drainage_was_said_) {
    doubt_of_what_was_said_ = doubt->reason;
    return;
  }
  const auto known = end();
  if (known && known->last <= doubt->last) return;
  const bool any = judged_first_ >= 0 && judged_first_ <= doubt->last;
  end_ = End{any ? std::min(doubt->last, judged_last_) : -1, doubt->reason};
  ends_at_mark_ = doubt->last < judged_last_;
}

/// An impossible state says that a sensor behind it gave no reading: it is left out as one on a
/// dead sensor is.
void JudgedStates::check_state(Judged& entry) {
  if (!entry.live || !complete(entry.state) || plausibility_.add(entry.state)) return;
  entry.reason = plausibility_.impossible(entry.state);
  entry.live = false;
  entry.dead = entry.impossible = true;
}

void JudgedStates::judge(Judged& entry) {
  const StageInfo* stage = header_.stage(entry.reading.stage);
  if (stage && stage->role == StageRole::b_check) wrong_in_b_check_ |= entry.wrong;
  if (stage && stage->role == StageRole::consolidation)
    plausibility_.add_consolidation(believed_state(entry).q);
  const bool undrained = watch_drainage(entry, stage);
  if (!is_watched(stage)) return;
  const bool first = !std::exchange(sheared_, true);
  if (first) wrong_at_shear_ = entry.wrong;
  if (first && entry.no_origin) end_ = End{-1, entry.reason + " at the start of shear"};
  if (first)
    if (auto reason = plausibility_.impossible_specimen(); !reason.empty())
      end_ = End{-1, std::move(reason)};
  if (end_) {
    entry.live = false;
    return;
  }
  entry.live = entry.live && undrained;
  if (auto lacking = volume_.reason(entry.state); entry.live && !lacking.empty()) {
    entry.live = false;
    entry.reason = std::move(lacking);
  }
  check_state(entry);
  if (!entry.live) {
    if (left_out_++ == 0) gap_reason_ = entry.reason;
    died_ = entry.dead;
    return;
  }
  if (!complete(entry.state)) return;
  if (left_out_ > sensor_limits::kMissing.count()) {
    if (!may_go_on(entry.state)) {
      end_ = End{last_live_ ? last_live_->reading : -1, gap_reason_};
      entry.live = false;
      return;
    }
    entry.after_gap = true;
  }
  left_out_ = 0;
  last_live_ = entry.state;
  judged_last_ = entry.reading.number;
  if (judged_first_ < 0) judged_first_ = judged_last_;
}

bool JudgedStates::shows_axis(const Judged& entry) const {
  return !entry.live && !entry.impossible && !(entry.wrong & kLoad) &&
         is_watched(header_.stage(entry.reading.stage)) && std::isfinite(entry.state.strain.axial);
}

bool JudgedStates::trusts_axis() const {
  return !axis_was_dead_ && !plausibility_.slip() && plausibility_.impossible_count() == 0 &&
         plausibility_.idle().empty() && plausibility_.backwards().empty();
}

std::optional<JudgedStates::End> JudgedStates::end() const {
  if (end_ || left_out_ == 0) return end_;
  const bool all_judged = finished_ && held_.empty();
  if (left_out_ <= sensor_limits::kMissing.count() && !(all_judged && died_)) return end_;
  return End{last_live_ ? last_live_->reading : -1, gap_reason_};
}

/// Why nothing of the verdict can stand; empty: it can.
std::string JudgedStates::withheld() const {
  if (!withheld_.empty()) return withheld_;
  const auto idle = plausibility_.idle();
  return idle.empty() ? plausibility_.backwards() : idle;
}

void JudgedStates::bound(Collapse& collapse) const {
  if (const auto reason = withheld(); !reason.empty()) {
    collapse.withhold(reason);
    return;
  }
  if (const auto& onset = collapse.onset; onset && onset->p_eff_pa && !(*onset->p_eff_pa > 0)) {
    collapse.withhold(
        fmt::format("p' is {:.1f} kPa at reading {}, zero within the error of the sensors: an "
                    "onset cannot be located there",
                    *onset->p_eff_pa / 1e3, onset->reading));
    return;
  }
  if (const auto& slip = plausibility_.slip()) collapse.end_at(slip->last, slip->reason);
  const auto end = this->end();
  if (!end) return;
  // Too few states before the end: its reason is the one that helps.
  const bool is_part_assessed = collapse.judged || collapse.judged_until;
  collapse.end_at(end->last >= 0 && is_part_assessed ? std::optional(end->last) : std::nullopt,
                  end->reason);
}

bool JudgedStates::is_possible(const State& state) const {
  return !complete(state) || !is_watched(header_.stage(state.stage)) ||
         plausibility_.is_possible(state);
}

std::vector<Warning> JudgedStates::warnings() const {
  std::vector<Warning> all = health_.warnings();
  for (auto& warning : plausibility_.warnings()) all.push_back(std::move(warning));
  if (!doubt_of_what_was_said_.empty())
    all.push_back({0, "the drainage is assessed as closed, as stated by the user, although " +
                          doubt_of_what_was_said_});
  if (const auto reason = withheld(); !reason.empty()) {
    all.push_back({0, "not assessed: " + reason});
  } else if (const auto end = this->end()) {
    all.push_back({0, end->last >= 0
                          ? fmt::format("not assessed after reading {}: {}", end->last, end->reason)
                          : fmt::format("not assessed: {}", end->reason)});
  }
  return all;
}

}  // namespace triax::lab
