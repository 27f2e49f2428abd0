// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Watches a segment for its events, numbers whose fall through zero tells something, and isolates
// them within a part.
#include <string>
#include <vector>

#include "sim/point/path_event.hpp"
#include "sim/point/segment_parts.hpp"

namespace triax::sim {

/// An event and the instant at or just beyond it.
template <class Space>
struct WitnessedEvent {
  PathEventKind kind = PathEventKind::end_condition;
  std::string what;
  PathInstant<Space> at;
};

/// End conditions, the second-order work W₂ = dσ′:dε over |dσ′||dε|, the growth of |q| and of the
/// stress part of the conditions that control no stress alone.
template <class Space>
class SegmentWitnesses {
 public:
  /// `parts` must outlive it.
  explicit SegmentWitnesses(const SegmentParts<Space>& parts);

  /// What holds at the segment's start already: end conditions that are met, and a negative W₂.
  std::vector<WitnessedEvent<Space>> at_start(const PathInstant<Space>& start);
  /// What happened between the start of a part and an instant of it, in that order: 1e-11 of the
  /// part is what it is isolated to.
  std::vector<WitnessedEvent<Space>> between(const PathInstant<Space>& from,
                                             const PathInstant<Space>& to);
  /// Whether W₂ was negative where the last look ended.
  bool work_is_negative() const;

 private:
  struct Witness {
    PathEventKind kind;
    std::string what;
    int index = -1;         // of the end condition or row; −1 of the peak: q
    double allowance = 0;   // what still counts as zero
    bool armed = false;     // it has been positive in this segment
    bool negative = false;  // it is
  };

  double value(const Witness& witness, const PathInstant<Space>& at) const;
  double end_value(const PathEnd& end, const PathInstant<Space>& at) const;
  double growth_of_row(int row, const PathInstant<Space>& at) const;
  bool fell(Witness& witness, const PathInstant<Space>& at) const;
  PathInstant<Space> isolate(const Witness& witness, const PathInstant<Space>& from,
                             const PathInstant<Space>& to) const;

  const SegmentParts<Space>& parts_;
  std::vector<Witness> witnesses_;
};

extern template class SegmentWitnesses<Axisymmetric>;
extern template class SegmentWitnesses<Tensor>;

}  // namespace triax::sim
