#pragma once
#include "lab/collapse/onset_fit.hpp"
#include "lab/collapse/path_history.hpp"

namespace triax::lab {

/// Places an onset that has been found more sharply than the windows that found it could, by
/// fit_onset over windows that grow around it as the test goes on. A longer window errs less by
/// noise and more by curvature; which one is best follows from the estimates themselves (rule of
/// intersecting confidence intervals): windows grow as long as the intervals t ± kConfidence δt of
/// all of them have a point in common, and the longest of these counts.
class OnsetRefiner {
 public:
  static constexpr double kConfidence = 2.5;

  /// An onset was found near this reading; the history reaches up to now.
  void begin(double reading, Witness witness, const PathHistory& history);
  /// Another sample is in the history.
  void follow(const PathHistory& history);
  /// Nothing after this reading bears on the onset: the stage ends, or a run-away begins.
  void finish(const PathHistory& history, double last_reading);
  /// The best so far; empty until a window shows the turn.
  const std::optional<OnsetFit>& onset() const { return best_; }
  /// Whether longer windows may still improve it.
  bool active() const { return active_; }

 private:
  void sweep(const PathHistory& history, double last_reading);
  void try_window(double first, double last, const PathHistory& history);

  bool active_ = false;
  Witness witness_ = Witness::second_order_work;
  double centre_ = 0;
  double last_age_ = 0;  ///< readings since the onset at the latest sweep
  int idle_ = 0;         ///< sweeps in a row that improved nothing
  std::optional<OnsetFit> best_;
};

}  // namespace triax::lab
