// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/point/segment_parts.hpp"

namespace triax::sim {

template <class Space>
SegmentParts<Space>::SegmentParts(const Law<Space>& law, const Segment<Space>& segment,
                                  const EffectiveControl<Space>& effective,
                                  const PointTolerance& tolerance)
    : law_(law),
      segment_(segment),
      effective_(effective),
      tolerance_(tolerance),
      count_(parts_of(segment)),
      part_(effective.control) {
  part_.increment /= count_;
}

template <class Space>
PointStep<Space> SegmentParts<Space>::step(const PathInstant<Space>& from, double share) const {
  if (stands_still()) {
    PointStep<Space> still;
    still.outcome = StepOutcome::accepted;
    still.state = from.state;
    still.done = 1;
    return still;
  }
  MixedControl<Space> control = part_;
  control.increment *= share;
  return advance_point(law_, from.state, control, tolerance_);
}

template <class Space>
PathInstant<Space> SegmentParts<Space>::instant(const PathInstant<Space>& from,
                                                const PointStep<Space>& step,
                                                double fraction) const {
  PathInstant<Space> at;
  at.state = step.state;
  at.strain = from.strain + step.strain_increment;
  at.pore_pressure = from.pore_pressure;
  if (effective_.undrained)
    at.pore_pressure += effective_.pore_pressure_change(fraction / count_, step.stress_increment,
                                                        step.strain_increment);
  at.fraction = fraction;
  at.progress = from.progress + fraction / count_;
  at.rate = rate_at(at.state);
  return at;
}

template <class Space>
std::optional<PathInstant<Space>> SegmentParts<Space>::within(const PathInstant<Space>& from,
                                                              double share) const {
  const PointStep<Space> tried = step(from, share);
  if (tried.outcome != StepOutcome::accepted && tried.outcome != StepOutcome::inaccurate)
    return std::nullopt;
  return instant(from, tried, share);
}

template <class Space>
PointRate<Space> SegmentParts<Space>::rate_at(const PointState<Space>& state) const {
  if (stands_still() || law_.objection(state)) return {};
  return point_rate(law_, state, part_);
}

template <class Space>
Vector<Space> SegmentParts<Space>::total_stress_rate(const PointRate<Space>& rate) const {
  Vector<Space> total = rate.stress;
  if (effective_.undrained)
    total +=
        effective_.pore_pressure_change(1.0 / count_, rate.stress, rate.strain) * identity<Space>();
  return total;
}

template class SegmentParts<Axisymmetric>;
template class SegmentParts<Tensor>;

}  // namespace triax::sim
