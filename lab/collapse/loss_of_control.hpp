// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Collapse as Nova defines it: the programme, with its control parameters, cannot be maintained.
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "lab/collapse/criterion.hpp"
#include "lab/collapse/loss_and_return.hpp"

namespace triax::lab {

/// Watches single readings, because a run-away may be over before any window is full. Four signs:
/// - a held q (constant_q) falls by more than 5 % and six standard deviations of what it was held
///   to;
/// - the axial strain bursts, under load or held q, at ten times the rate of the stage so far or
///   more;
/// - before the stage has shown a rate, the axial strain leaps by 1 % or more from one reading to
///   the next, be it from the last reading of the stage before, and q (in extension q times the
///   area) falls by more than 5 % with it, or, onward, by more than half of the leap: a load that
///   the specimen carries does not fall. A leap with which q grows is a step of the load, and told;
/// - the pore pressure bursts, like the strain, beyond what the programme asks of it, by 5 % of p'
///   at least. With the valve closed it is asked to follow the cell pressure (B near 1), with the
///   valve open to stand, or to go on as the controller took it so far.
/// A burst of half a per cent or more during which the load did not grow by half as much is a
/// runaway: dq dε < 0 on the growing area. It stands whatever q does later; whether strength came
/// back is another question (LossAndReturn), and once it did by 5 % beyond what it was the watch
/// begins anew, for the next one.
/// Any other burst under a load after which q never fell by 5 %, and went on for kCalm readings, or
/// q or the load itself grew by 5 % (at constant q on a growing area, as on a limit surface), took
/// nothing away: the programme holds, unless the load fell by 5 % (in extension it does at a q that
/// grows, on an area that shrinks). It is told, but not counted.
/// A record that ends sooner says nothing against the loss. A frame that
/// prescribes displacement keeps its control through a peak: nothing is looked for. Where nobody
/// says what is prescribed, a burst of the axial strain counts that is ten times faster than the
/// fastest step so far, while q falls by more than 5 %: no frame does that.
class LossOfControl : public CollapseCriterion {
 public:
  static constexpr std::string_view kName = "loss_of_control";

  void start_stage(const StageInfo* stage) override;
  void add_state(const State& state, bool has_time) override;
  /// A state of which only what the axis did can be believed: q may be unknown (NaN), and the pore
  /// pressure is not looked at.
  void add_axis(const State& state, bool has_time);
  /// Not detected where a load was carried on.
  std::optional<Finding> finding() const override;
  std::string blind() const override;
  const std::optional<Finding>& found() const { return run_.finding; }
  /// The state from which that began; null without one.
  const State* before() const { return run_.finding ? &run_.before : nullptr; }
  /// The force beyond that of the cell pressure, on a cross-section of one when shear began.
  static double carried_load(const State& state);
  /// The finding, where control was lost for all that is known: of several runaways the last that
  /// took strength away, or the first if it came back after each.
  std::optional<Finding> lost() const;
  /// Number of the last reading that was looked at.
  std::int64_t last_reading() const { return before_.reading; }
  /// What that took and gave back; null without one.
  const LossAndReturn* loss() const;
  /// The first burst that was over before the watch began anew.
  const std::optional<Finding>& earlier() const { return earlier_.finding; }
  /// Whether the finding is a fall, 1 % of axial strain or more from one reading to the next, of a
  /// specimen that had carried its stage until then.
  bool sudden() const { return run_.fall.has_value(); }
  /// Of a sudden one the reading before it and the one that shows it.
  struct Fall {
    State before, after;
  };
  const std::optional<Fall>& fall() const { return run_.fall; }

 private:
  void add(const State& state, bool has_time);
  struct Run;
  void begin(const State& from, std::string evidence, bool has_time);
  void look(const State& before, const State& state, bool has_time);
  void follow(const State& state);
  void watch_anew();
  const Run* decisive() const;
  void check_held_q(const State& state, bool has_time);
  void check_bursts(const State& state, bool has_time);
  void check_leap(const State& before, const State& state, bool has_time);
  void check_strain_burst(bool has_time);
  bool bursts_open(const State& before, const State& state) const;
  bool outruns_any_frame(bool has_time) const;
  void check_pore_burst(bool has_time);
  double pore_excess(const State& from, const State& to) const;

  static constexpr int kReference = 20;  ///< readings that say at which q a stage holds
  static constexpr int kRecent = 5;      ///< readings over which a burst is looked for

  bool looked_ = false;  ///< in any stage
  State before_;         ///< the last one, of whatever stage
  Drainage drainage_ = Drainage::unknown;
  AxialControl control_ = AxialControl::displacement;
  std::int64_t count_ = 0;
  int held_count_ = 0;  ///< readings of q_mean_
  double q_mean_ = 0, q_square_ = 0;
  int below_ = 0;  ///< successive readings at which the held q is missing
  State first_below_;
  std::array<State, kRecent> recent_{};
  int whole_ = 0;            ///< readings since the last of the axis only
  double largest_rate_ = 0;  ///< of the axial strain from one reading to the next
  double mean_rate_ = 0;  ///< of the axial strain before the recent readings, per s or per reading
  double mean_pore_rate_ = 0;  ///< of the pore pressure beyond what is asked, likewise
  std::int64_t steps_ = 0;
  static constexpr int kCalm = 10;
  /// A burst and what came after it.
  struct Run {
    std::optional<Finding> finding{};
    std::optional<Fall> fall{};
    std::optional<LossAndReturn> loss{};
    State before{}, previous{};
    bool under_load = false;  ///< the burst came so
    bool over = false;        ///< its stage is
    int readings = 0;
    double least = 0, last = 0;  ///< |q|
    double first_load = 0, load = 0, min_load = 0;
    bool ran_away = false;  ///< the load did not grow as the strain did
    void add(const State& state);
    bool carried_on() const;
    bool lost() const { return finding && !carried_on(); }
    /// The finding, withdrawn if the load increased further.
    Finding final_finding() const;
  };
  Run run_, earlier_;
  std::optional<Finding> step_;  ///< a leap with which the load grew
};

}  // namespace triax::lab
