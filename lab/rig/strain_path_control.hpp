#pragma once
// The volume control of a proportional strain path: what has to flow out of the specimen so that
// dε₁ + 2R dε₃ = 0 (Eq. 28) holds in natural strains since the start of the stage,
//
//   V = V₀ (H/H₀)^(1 − 1/R)
//
// at the end of the tick, H being what the crosshead will have made of the height read. Volumes are
// those of the back controller, so that what was missed before is made good.
#include <optional>

#include "lab/programmes/programme.hpp"
#include "lab/rig/seen.hpp"

namespace triax::lab {

class StrainPathControl {
 public:
  /// `built_height_m` is that from which the axial displacement counts.
  explicit StrainPathControl(double built_height_m) : built_height_m_(built_height_m) {}

  /// A new stage counts its strains from what is seen now.
  void begin_stage(const Stage& stage, const Seen& seen);
  /// Flow out of the specimen over the next dt, m³/s; empty where the stage prescribes no path.
  std::optional<double> outflow_m3_per_s(const Seen& seen, double dt_s) const;

 private:
  double height_m(const Seen& seen) const;

  double built_height_m_;
  std::optional<double> R_;
  double axial_rate_m_per_s_ = 0;
  double start_height_m_ = 0, start_volume_m3_ = 0, start_back_volume_m3_ = 0;
};

}  // namespace triax::lab
