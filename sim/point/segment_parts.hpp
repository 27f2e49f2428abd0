// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A segment cut into equal parts, each of them one increment of the point driver.
#include <optional>

#include "sim/point/path.hpp"
#include "sim/point/point_driver.hpp"

namespace triax::sim {

/// The point at an instant within a segment.
template <class Space>
struct PathInstant {
  PointState<Space> state;
  Vector<Space> strain = Vector<Space>::Zero();  ///< since the start of the path
  double pore_pressure = 0;                      ///< Pa
  double progress = 0;                           ///< of the segment, 0 to 1
  double fraction = 0;                           ///< of the part, 0 to 1
  PointRate<Space> rate;  ///< over one part; not controllable where the law has none
};

/// The law, the segment, its control and the tolerance must outlive it.
template <class Space>
class SegmentParts {
 public:
  SegmentParts(const Law<Space>& law, const Segment<Space>& segment,
               const EffectiveControl<Space>& effective, const PointTolerance& tolerance);

  int count() const { return count_; }
  const Segment<Space>& segment() const { return segment_; }
  const EffectiveControl<Space>& effective() const { return effective_; }

  /// Nothing acts on the skeleton: only the pore pressure follows a total stress.
  bool stands_still() const { return part_.increment.isZero(0); }
  /// This share of a part, begun at an instant.
  PointStep<Space> step(const PathInstant<Space>& from, double share) const;
  /// Where a step over this fraction of the part that starts at `from` leads.
  PathInstant<Space> instant(const PathInstant<Space>& from, const PointStep<Space>& step,
                             double fraction) const;
  /// The instant after this share of the part that starts at `from`; empty where it cannot be had.
  std::optional<PathInstant<Space>> within(const PathInstant<Space>& from, double share) const;
  /// Response at a state; not controllable where the law objects or the part stands still.
  PointRate<Space> rate_at(const PointState<Space>& state) const;
  /// Rate of the TOTAL stress over one part, for an instant with a rate.
  Vector<Space> total_stress_rate(const PointRate<Space>& rate) const;

 private:
  const Law<Space>& law_;
  const Segment<Space>& segment_;
  const EffectiveControl<Space>& effective_;
  const PointTolerance& tolerance_;
  int count_;
  MixedControl<Space> part_;
};

extern template class SegmentParts<Axisymmetric>;
extern template class SegmentParts<Tensor>;

}  // namespace triax::sim
