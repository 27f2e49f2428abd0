// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the onset will be: the stress ratio at which what the specimen answers with stops growing.
//
// Along the driven path (DrivenPath) sustainability is lost where dy/dx = 0: there second-order
// work vanishes, W2 = dq dε₁ along a strain path, dp′ dε_v at held q. On the way there
//
//   dy/dx = g (f₀ + f₁ξ + f₂ξ²),   ξ = (η − η now)/d,   f₂ = 0 along a strain path,
//
// and integrated, y = c + f₀∫g dx + f₁∫gξ dx + f₂∫gξ² dx, which is linear in all that is sought and
// is fitted to the readings themselves by least squares, over the last kReach times the distance d
// that is left to the root. Along a strain path p′ is fitted likewise, dp′/dx = g (r₀ + r₁ξ): where
// it would fall no longer as dy/dx vanishes the path does not come to that η; it turns at its phase
// transformation, and no onset is ahead. The two fits make a second witness: −(dy/dp′) √η, which
// goes to zero with dy/dx, straight where the first is bent. The forecast is the mean of the two,
// and half of what lies between them is a part of its error. Measured on the laws of triax
// (bench/warning): stiffness is straight in INL2; bent in SANISAND and hypoplasticity, where it
// comes out early; octolinear has a knee, which no witness sees before it is reached. All err by a
// fraction of the distance, and more often it is too short: beside the error of the fit the
// distance is known up to a factor, of log-normal distribution.
//
// Where pore fluid and lines give way (SpecimenVolume) work is taken with that strain.
//
// Past the onset, where y comes down for certain, the forecast is the η of the largest y.
#include <optional>
#include <utility>
#include <vector>

#include "lab/results/forecast.hpp"
#include "lab/warning/driven_path.hpp"
#include "lab/warning/earlier_tests.hpp"

namespace triax::lab {

struct EtaForecast {
  double eta = 0;                             ///< |η| at the onset to come
  double error = 0;                           ///< standard error towards smaller η
  double error_above = 0;                     ///< and towards larger η
  double now = 0;                             ///< |η| of the latest readings
  double stiffness = 0, stiffness_error = 0;  ///< dy/dx now, over the largest that was seen
  /// What of η is left, as a share of the way to the onset.
  double left() const { return (eta - now) / eta; }
  double covered = 0;  ///< η since the start of the stage, as a share of η now
  /// Of what drives the stage until η is `at`: q, p′ or ε₁.
  double way_to(double at) const;

  AxialControl by = AxialControl::unknown;
  double q = 0;            ///< now, Pa
  double slope = 0;        ///< dη/dx now
  double slope_there = 0;  ///< and at the onset
  /// Normalised second-order work now, d²W/(|dσ′||dε|), and its standard error; 1 and 0 at held q
  /// with the valve closed, where nothing measures dε_v.
  double work = 1, work_error = 0;
  /// −dp′/dx at the onset over what it is now, along a strain path: 1 and more where loose sand
  /// falls, well below where p′ turns at phase transformation.
  double fall = 1;
  double answer = 0;        ///< dy/dx now
  bool by_earlier = false;  ///< earlier tests of the sand have their share in it
};

struct DrivenFit;

class OnsetForecast {
 public:
  explicit OnsetForecast(EarlierTests earlier = {}) : earlier_(std::move(earlier)) {}
  /// A stage begins, and all is forgotten unless it is the way back from a loop.
  void start_stage(const StageInfo* stage, bool has_time, const SpecimenVolume& volume = {});
  void forget();
  /// The next reading in shear; true where the forecast was made anew. Pre-condition:
  /// complete(state).
  bool add(const State& state);
  /// As it stands; empty where nothing points at an onset, or too little was seen of the stage.
  const std::optional<EtaForecast>& now() const { return forecast_; }
  /// The fraction of an independent observation that the latest forecast adds to the one before:
  /// both are of the same readings but for a few. 0 to 1.
  double new_evidence() const { return new_evidence_; }
  /// Of the stage there is enough to say that nothing points at an onset.
  bool clear() const { return clear_; }
  /// Change of what drives the stage a unit of progress, at present; empty where it stands still.
  std::optional<double> rate() const;
  std::int64_t readings() const { return path_.readings(); }
  DrivenPath::Control control() const { return path_.control(); }
  bool in_extension() const { return path_.in_extension(); }
  /// The least work with which earlier tests of the sand, driven so, carried on.
  std::optional<double> carried_on() const {
    return earlier_.carried_on(path_.control(), path_.in_extension());
  }
  /// None of those carried on.
  bool earlier_agree() const { return earlier_.agree(path_.control(), path_.in_extension()); }

 private:
  std::optional<EtaForecast> made();
  std::optional<EarlierTests::Onset> known(double now) const;
  std::optional<EtaForecast> known_alone(const PathMean& here) const;
  EtaForecast described(const DrivenFit& f, const PathMean& here, double weight);

  EarlierTests earlier_;
  DrivenPath path_;
  AxialControl by_ = AxialControl::unknown;
  std::optional<EtaForecast> forecast_;
  bool clear_ = false;
  double stiffest_ = 0, new_evidence_ = 1;
  std::int64_t looked_ = 0;  ///< readings at the last look
};

}  // namespace triax::lab
