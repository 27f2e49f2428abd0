// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <optional>

#include "lab/collapse/onset_fit.hpp"
#include "lab/measured/path_history.hpp"

namespace triax::lab {

/// Places an onset that has been found more sharply than the windows that found it could.
///
/// fit_onset is asked over a family of windows around it: to the right they end between a ninth of
/// the readings since and the last one, to the left they reach one to four times as far, for what
/// follows an onset soon runs away while what precedes it is smooth. A short window errs by noise,
/// a long one by what a cubic cannot follow; each says how much, and the median of all of them with
/// the weights 1/δt is neither's. This is done when the onset is found and again as the test goes
/// on, until three times as many readings follow the onset; longer windows see the residual state.
class OnsetRefiner {
 public:
  /// An onset was found near this reading; the history reaches up to now.
  void begin(double reading, Witness witness, const PathHistory& history);
  /// Another sample is in the history.
  void follow(const PathHistory& history);
  /// Nothing after this reading bears on the onset: the stage ends, or a run-away begins.
  void finish(const PathHistory& history, double last_reading);
  /// The best so far; empty until a window shows the turn.
  const std::optional<OnsetFit>& onset() const { return best_; }
  /// The onset as it would be if the volume were another one: `change` is added to the volumetric
  /// strain of every sample, of which it gets the pore pressure (Pa). Empty without a turn.
  std::optional<OnsetFit> with_volume(const PathHistory& history, double last_reading,
                                      const std::function<double(double)>& change) const;
  /// How often it was sought: onset() changes with this number only.
  int revision() const { return revision_; }
  /// Whether more readings may still improve it.
  bool active() const { return active_; }

 private:
  void sweep(const PathHistory& history, double last_reading);
  std::optional<OnsetFit> sweep_around(const PathHistory& history, double around,
                                       double last_reading,
                                       const std::function<double(double)>& change) const;

  bool active_ = false;
  int revision_ = 0;
  Witness witness_ = Witness::second_order_work;
  double centre_ = 0;
  double first_ = 0, swept_ = 0;  ///< readings since the onset, at the first and latest sweep
  std::optional<OnsetFit> best_;
};

}  // namespace triax::lab
