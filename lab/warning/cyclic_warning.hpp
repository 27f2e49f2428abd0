// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Warning one load cycle before the failure of an undrained cyclic test.
//
// A load cycle is compared with the cycle before it at the same phase: the same direction of q and
// the same q. Stresses are effective. s is the sine of the mobilised friction angle,
//
//   s = 3η/(6 + η),   η = q/p′,   p′ at least 0.05 p′₀
//
// negative in extension. q_a is half the range of q and q_m its middle. Four numbers describe the
// latest cycle, without units:
//
//   growth    ln max(Δ|s|, 0.003)      largest growth of |s| near the two ends of the load, and
//                                      above all that was reached before
//   against the cycle before           ln((W + W₀)/(W_before + W₀)), from −1 to 0.5
//   against the first cycle            ln((W + W₀)/(W_first + W₀)), from −1 to 2
//   shift     max|ε − ε_before|/ε_r    at most 1; ε_r: range of axial strain in the cycle
//
// with W = ∫(q − q_m) dε at least 0 and W₀ = 0.02 q_a ε_r. In front of the first cycle there is a
// virtual one with the same q and without excess pore pressure (p′ = p′₀). Then
//
//   P = 1/(1 + exp(−z)),   z = c₀ + Σ cᵢ xᵢ
//
// is the probability that the specimen fails within one load cycle. bench/recorded/fit_cyclic.py
// fits c to recorded tests (30 tests on Toyoura sand, github.com/ku-geo) and prints how well the
// model does on tests that it was not fitted to. The numbers contain no level of friction or
// strain, so they do not depend on the density. Dense sand that shows cyclic mobility gets one
// warning, when it loses most of p′ for the first time; the warning is withdrawn. Not tried: clay,
// strain-controlled cycles.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lab/measured/bend_noise.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Half a load cycle, from one turn of q to the next, in at most kMaxSamples samples.
class LoadBranch {
 public:
  struct Sample {
    double q = 0;              ///< Pa
    double strain = 0;         ///< axial
    double work = 0;           ///< ∫q dε since the start of shear, J/m³
    double s = 0;              ///< sine of the mobilised friction angle
    double growth = kMissing;  ///< of |s| since the cycle before; NaN: not known
    double shift = kMissing;   ///< |ε − ε_before|; NaN: not known
  };
  static constexpr std::size_t kMaxSamples = 64;

  /// `direction` of q: 1 or −1.
  explicit LoadBranch(int direction = 0) : direction_(direction) {}
  /// Neighbours are merged if there are too many.
  void add(const Sample& sample);
  void set_direction(int direction) { direction_ = direction; }
  const std::vector<Sample>& samples() const { return samples_; }
  std::vector<Sample>& samples() { return samples_; }
  /// Index of the first sample at q or beyond it; the number of samples if there is none.
  std::size_t index_at(double q) const;
  /// By linear interpolation; q is limited to the range of the branch. Empty if q lies outside
  /// that range by more than `tolerance`.
  std::optional<Sample> at(double q, double tolerance) const;

 private:
  int direction_;
  std::size_t count_ = 0, stride_ = 1;  ///< readings, and how many a sample is of
  std::vector<Sample> samples_;
};

/// Processes the states of undrained shear one at a time, in constant memory. It counts in load
/// cycles: at a turn, q comes back by more than a tenth of its range, 2 % of p′₀, and
/// assessment_limits::kNoise times its noise. If an end of the load moves by more than
/// warning_limits::kChangedEnd, or the load rests for longer than a cycle, the comparison starts
/// again with the next cycle. A warning is issued at P = kIssue. It is withdrawn below P =
/// kWithdraw at a turn of q, if the specimen carried the load up to there. It is never changed
/// while the comparison starts again.
class CyclicWarning {
 public:
  enum class Restart { none, larger_load, smaller_load, rest, interruption };
  static constexpr std::size_t kNumbers = 4;
  using Numbers = std::array<double, kNumbers>;

  explicit CyclicWarning(bool has_time) : has_time_(has_time) {}
  /// Pre-conditions: complete(state); the drainage is closed. True if the level has changed.
  bool add(const State& state);
  /// Forgets the test, and its warning.
  void reset() { *this = CyclicWarning(has_time_); }

  /// Readings are missing or belong to another loading: the comparison starts again, and the
  /// warning is no longer in force.
  void interrupt();

  /// The load is cyclic by its last turns, or by the record.
  bool is_cyclic() const;
  bool is_imminent() const { return is_imminent_; }
  /// Of the latest reading. Empty: no cycle to compare with.
  const std::optional<Numbers>& numbers() const { return numbers_; }
  /// P, latest known; 0 before the first.
  double probability() const { return probability_; }
  static double probability(const Numbers& numbers);
  double cycles() const { return turns_ / 2.0; }  ///< half cycles that are complete, halved
  /// q has turned with the latest reading, not before the last end of the load on that side.
  bool load_was_carried() const { return load_was_carried_; }
  /// Why and when the comparison last started again.
  Restart restart() const { return restart_; }
  double restarted_at_cycles() const { return restarted_at_; }

 private:
  struct Turn {
    double q = 0, at = 0;  ///< Pa, and time or number of readings
  };
  struct Work {
    double now = 0;
    std::optional<double> before;
  };
  void begin(const State& state);
  bool rests(double q, double at);
  void follow(LoadBranch::Sample sample, double at);
  void extend(LoadBranch::Sample sample, double at);
  void turn(const LoadBranch::Sample& sample, double at);
  void start_again(Restart why);
  bool is_loaded_first() const;
  void keep_reached(const LoadBranch& branch);
  void compare(LoadBranch::Sample& sample) const;
  bool has_cycle_before() const;
  std::optional<Numbers> describe_cycle();
  std::optional<Work> work_of_cycle() const;
  std::vector<const LoadBranch::Sample*> latest_cycle() const;
  double sine(double q, double p_eff) const;
  double min_range() const;
  double range() const;
  double middle() const;
  std::optional<double>& end(int direction) { return ends_[direction > 0 ? 1 : 0]; }

  bool has_time_;
  std::optional<State> first_;
  double start_q_ = 0;         ///< of the first half cycle, Pa
  double low_ = 0, high_ = 0;  ///< of q, Pa
  double count_ = 0, work_ = 0;
  BendNoise noise_;  ///< of q
  std::optional<State> latest_;
  int direction_ = 0;                          ///< of q; 0 before it moved
  Turn extreme_;                               ///< of q since the last turn
  Turn anchor_;                                ///< from which the load may rest
  std::vector<double> turn_times_;             ///< the last three
  std::array<std::optional<double>, 2> ends_;  ///< of the load: the last low and high turn, Pa
  LoadBranch current_;
  std::optional<LoadBranch> behind_;  ///< readings past the extreme, perhaps a new branch
  std::vector<LoadBranch> earlier_;   ///< the last four complete ones, latest first
  std::optional<double> first_work_;
  std::array<double, 2> reached_{};  ///< largest |s| a cycle ago and before, by the sign of q
  bool has_virtual_cycle_ = true;
  int turns_ = 0;
  bool counts_cycles_ = false;  ///< the record counts load cycles
  Restart restart_ = Restart::none;
  double restarted_at_ = 0;
  std::optional<Numbers> numbers_;
  double probability_ = 0;
  bool load_was_carried_ = false;
  bool is_imminent_ = false;
};

/// "the load became larger".
std::string describe(CyclicWarning::Restart restart);

}  // namespace triax::lab
