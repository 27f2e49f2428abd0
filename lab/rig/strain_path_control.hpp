// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The volume control of a proportional strain path: what has to flow out of the specimen so that
// dε₁ + 2R dε₃ = 0 (Eq. 28 of the paper) holds in natural strains since the start of the stage,
//
//   V = V₀ (H/H₀)^(1 − 1/R).
//
// Volumes are those of the back controller, so that what was missed before is made good: at the end
// of the tick by an ideal servo, over the time constant of one that smooths the height it reads. A
// flow that followed every look would carry the noise of the displacement transducer into the
// specimen, which then goes to and fro by more than it is led.
#include <optional>

#include "lab/programmes/programme.hpp"
#include "lab/rig/seen.hpp"
#include "lab/rig/trend_filter.hpp"

namespace triax::lab {

class StrainPathControl {
 public:
  /// `built_height_m` is that from which the axial displacement counts; `filter_s` 0: no smoothing.
  StrainPathControl(double built_height_m, double filter_s)
      : built_height_m_(built_height_m), height_(filter_s) {}

  /// A new stage counts its strains from what is seen now.
  void begin_stage(const Stage& stage, const Seen& seen);
  /// Flow out of the specimen over the next dt, m³/s; empty where the stage prescribes no path.
  std::optional<double> outflow_m3_per_s(const Seen& seen, double dt_s);

 private:
  double height_m(const Seen& seen) const;
  /// V that belongs to a height.
  double wanted_m3(double height_m) const;

  double built_height_m_;
  TrendFilter height_;
  std::optional<double> R_;
  double axial_rate_m_per_s_ = 0;
  double start_height_m_ = 0, start_volume_m3_ = 0, start_back_volume_m3_ = 0;
};

}  // namespace triax::lab
