// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/segment_witnesses.hpp"

#include <algorithm>
#include <cmath>

namespace triax::sim {
namespace {

/// Rates, as shares of their natural size, that count as zero: round-off of the control's solution.
constexpr double kNoRate = 1e-9;
/// An event is isolated to this share of a part of a segment.
constexpr double kIsolated = 1e-11;

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

}  // namespace

template <class Space>
SegmentWitnesses<Space>::SegmentWitnesses(const SegmentParts<Space>& parts) : parts_(parts) {
  const Segment<Space>& segment = parts.segment();
  for (std::size_t i = 0; i < segment.end.size(); ++i)
    witnesses_.push_back(
        {PathEventKind::end_condition, segment.end[i].label, static_cast<int>(i), 0});
  witnesses_.push_back({PathEventKind::second_order_work, "second-order work", -1, kNoRate});
  witnesses_.push_back({PathEventKind::peak, "q", -1, kNoRate});
  const MixedControl<Space>& given = segment.conditions;
  for (int row = 0; row < Space::kSize; ++row)
    if (!given.stress.row(row).isZero(0) && !given.strain.row(row).isZero(0))
      witnesses_.push_back(
          {PathEventKind::peak,
           "stress part of " + parts.effective().labels[static_cast<std::size_t>(row)], row,
           kNoRate});
}

template <class Space>
double SegmentWitnesses<Space>::end_value(const PathEnd& end, const PathInstant<Space>& at) const {
  PathPoint<Space> point;
  point.stress = at.state.stress;
  point.strain = at.strain;
  point.void_ratio = at.state.void_ratio;
  point.pore_pressure = at.pore_pressure;
  const auto quantity = value_of(end.quantity, end.component, point);
  if (!quantity) return 1;
  return end.above ? *end.above - *quantity : *quantity - *end.below;
}

template <class Space>
double SegmentWitnesses<Space>::growth_of_row(int row, const PathInstant<Space>& at) const {
  const auto stress_part = parts_.segment().conditions.stress.row(row);
  const Vector<Space> rate = parts_.total_stress_rate(at.rate);
  const Vector<Space> stress = at.state.stress + at.pore_pressure * identity<Space>();
  const double level = stress_part.dot(stress), change = stress_part.dot(rate);
  const double norm = stress_part.norm() * rate.norm();
  return norm > 0 && level != 0 ? std::copysign(change / norm, level * change) : 0;
}

template <class Space>
double SegmentWitnesses<Space>::value(const Witness& witness, const PathInstant<Space>& at) const {
  if (witness.kind == PathEventKind::end_condition)
    return end_value(parts_.segment().end[static_cast<std::size_t>(witness.index)], at);
  if (!at.rate.controllable) return 0;
  if (witness.kind == PathEventKind::second_order_work) return at.rate.normalised_work();
  if (witness.index < 0) return growth_of_q<Space>(at.state.stress, at.rate.stress);
  return growth_of_row(witness.index, at);
}

template <class Space>
std::vector<WitnessedEvent<Space>> SegmentWitnesses<Space>::at_start(
    const PathInstant<Space>& start) {
  std::vector<WitnessedEvent<Space>> found;
  for (Witness& witness : witnesses_) {
    const double at_start = value(witness, start);
    witness.armed = at_start > witness.allowance;
    if (witness.kind == PathEventKind::end_condition && at_start <= 0)
      found.push_back({witness.kind, witness.what, start});
    if (witness.kind != PathEventKind::second_order_work || !(at_start < -witness.allowance))
      continue;
    witness.negative = true;
    found.push_back({witness.kind, witness.what, start});
  }
  return found;
}

/// Takes note of the witness's sign; true where its fall tells something.
template <class Space>
bool SegmentWitnesses<Space>::fell(Witness& witness, const PathInstant<Space>& at) const {
  const double now = value(witness, at);
  if (now > witness.allowance) {
    witness.armed = true;
    witness.negative = false;
    return false;
  }
  const bool end = witness.kind == PathEventKind::end_condition;
  if (!end && (!(now < -witness.allowance) || witness.negative)) return false;
  const bool tells = witness.armed || witness.kind == PathEventKind::second_order_work;
  witness.armed = false;
  witness.negative = true;
  return tells;
}

template <class Space>
std::vector<WitnessedEvent<Space>> SegmentWitnesses<Space>::between(const PathInstant<Space>& from,
                                                                    const PathInstant<Space>& to) {
  PathInstant<Space> last = to;
  // Where control was lost there is no rate; that of just before tells what led there.
  if (!to.rate.controllable && to.fraction > 0 && !parts_.stands_still())
    if (auto before = parts_.within(from, to.fraction * (1 - 1e-6))) last.rate = before->rate;
  std::vector<WitnessedEvent<Space>> found;
  for (Witness& witness : witnesses_)
    if (fell(witness, last))
      found.push_back({witness.kind, witness.what, isolate(witness, from, last)});
  std::ranges::stable_sort(found, {}, [](const auto& one) { return one.at.fraction; });
  return found;
}

/// The zero of the witness between two instants, at or just beyond it: false position in the
/// Illinois form, with a halving now and then for witnesses that jump.
template <class Space>
PathInstant<Space> SegmentWitnesses<Space>::isolate(const Witness& witness,
                                                    const PathInstant<Space>& from,
                                                    const PathInstant<Space>& to) const {
  const double zero = value(witness, from) > 0 ? 0 : -witness.allowance;
  double low = 0, high = to.fraction;
  double at_low = value(witness, from) - zero, at_high = value(witness, to) - zero;
  PathInstant<Space> beyond = to;
  for (int i = 0; i < 100 && high - low > kIsolated; ++i) {
    const bool halve = i % 4 == 3 || !(at_low > 0) || !(at_high < 0);
    const double share = halve ? 0.5 : at_low / (at_low - at_high);
    double middle = low + share * (high - low);
    if (!(middle > low && middle < high)) middle = 0.5 * (low + high);
    const auto tried = parts_.within(from, middle);
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

template <class Space>
bool SegmentWitnesses<Space>::work_is_negative() const {
  return std::ranges::any_of(witnesses_, [](const Witness& witness) {
    return witness.kind == PathEventKind::second_order_work && witness.negative;
  });
}

template class SegmentWitnesses<Axisymmetric>;
template class SegmentWitnesses<Tensor>;

}  // namespace triax::sim
