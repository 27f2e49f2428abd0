// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the onset will be: the stress ratio at which second-order work is going to vanish.
//
// W2 falls to zero over the stress ratio η long before the specimen falls. Divided by a power of
// the stiffness |dσ′|/|dε| it falls along a straight line,
//
//   y = W2/(|dσ′|^{1+b} |dε|^{1−b})     b = −1: work per square of the strain, a stiffness;
//                                       b = +1: per square of the stress, a compliance,
//
// with b by what drives the test. Where the strain path is prescribed (undrained, or dε₁ + 2R dε₃ =
// 0; by displacement, load or spring) the stiffness dq/dε₁ of loose sand falls linearly over η. At
// held q with the drainage open it is a mixture near the normalised work, b = 0.25. At held q with
// the valve closed the volume moves with the pore pressure, dε_v = C du, and y = du/dp′. A line
// through what lies within three times the distance that is left is continued to y = 0. Measured on
// the laws of triax (bench/warning): INL2 is straight; SANISAND and hypoplasticity are bent, by up
// to half of what is left. So the error holds a share of that distance beside scatter and bend.
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lab/measured/path_rates.hpp"
#include "lab/results/record_header.hpp"
#include "lab/warning/straight_line.hpp"

namespace triax::lab {

struct EtaForecast {
  double eta = 0;    ///< |η| at the onset to come
  double error = 0;  ///< standard error
  double now = 0;    ///< |η| of the latest point
  /// What of η is left, as a share of the way to the onset.
  double left() const { return (eta - now) / eta; }
};

class OnsetForecast {
 public:
  /// What falls along a straight line over η.
  enum class Witness { none, stiffness, normalised, mixture, pore_pressure };
  /// The one that is right for what drives a stage; none with the drainage open under prescribed
  /// displacement, where nothing is lost but at the limit surface.
  static Witness witness_of(const StageInfo* stage);

  /// Looks within `reach` times the distance that is left are fitted.
  explicit OnsetForecast(double reach = 3) : reach_(reach) {}
  /// A stage begins, and all is forgotten.
  void start_stage(Witness witness);
  /// The next point of the driven path, in the order of readings.
  void add(const PathPoint& point);
  /// As it stands; empty where nothing points at an onset, or too little was seen of the stage.
  const std::optional<EtaForecast>& now() const { return forecast_; }

 private:
  struct Look {
    double eta = 0, y = 0, sigma = 0, share = 0;
  };
  std::optional<Look> look_at(const PathPoint& point) const;
  void remember(const Look& look);
  void merge_pairs();
  StraightLine through(double distance, double reach) const;
  std::optional<EtaForecast> made() const;

  double reach_;
  Witness witness_ = Witness::none;
  bool in_extension_ = false;
  std::vector<Look> looks_;  ///< bounded; each of `merged_` points but the last, of `in_last_`
  int merged_ = 1, in_last_ = 0;
  double last_reading_ = 0;
  /// The least |η| by which an onset was said to come for certain: beyond it this stage is none
  /// that a straight line foretells.
  double promised_ = std::numeric_limits<double>::infinity();
  std::optional<EtaForecast> forecast_;
};

}  // namespace triax::lab
