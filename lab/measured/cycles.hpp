// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cycles of load as they come, in constant memory.
#include <deque>
#include <optional>

#include "lab/measured/bend_noise.hpp"
#include "lab/results/state.hpp"
#include "lab/results/summary.hpp"

namespace triax::lab {

/// Counts the turns of q, or, where the strain is driven to and fro while q fades, those of the
/// axial strain (by kMinStrain and kNoise times its noise), beside what the logger counts itself:
/// where it comes back by more than kLeast p′₀ and kNoise times its noise. Two turns are a
/// cycle; from kFewest turns on a test is a cyclic one. The double amplitude is the strain from
/// turn to turn, counted while q lies between the last two of them: shear that goes on beyond them,
/// between loops of unloading or after the cycles, is none. Of cycles of strain it is what was
/// prescribed, and says nothing.
class CycleCounter {
 public:
  static constexpr double kLeast = 0.05;
  static constexpr double kMinStrain = 5e-4;
  static constexpr int kFewest = 4;

  explicit CycleCounter(bool has_time) : has_time_(has_time) {}

  /// States of shear with the water shut in. Pre-condition: complete(state).
  void add(const State& state);
  bool has_liquefied() const { return found_.liquefied || found_.double_amplitude; }
  /// Empty: the test is not a cyclic one.
  std::optional<CyclicLoading> loading() const;
  /// Whether q came back after that reading and turned at nine tenths of `q` or more, on its side:
  /// the load was carried again. The first turn after it, where q falls from what it was, does not
  /// count.
  bool carried_on(std::int64_t reading, double q) const;

 private:
  struct Turn {
    std::int64_t reading = 0;
    double q = 0;
  };
  struct Range {
    double low = 0, high = 0;
    void add(double value);
    double size() const { return high - low; }
  };
  struct Mean {
    double value = 0;
    int count = 0;
    void add(double next) { value += (next - value) / ++count; }
  };
  void follow(const State& state);
  void follow_strain(double strain);
  bool by_strain() const { return strain_turns_ > turns_ + 1; }
  int turns() const { return by_strain() ? strain_turns_ : turns_; }
  bool is_within_the_cycles(double q) const;
  void reach(const State& state);
  void turn(const State& state);
  void watch_pore_pressure(const State& state);
  void watch_strain(const State& state);
  CycleInstant at(const State& state) const;
  int cycle_of(const State& state) const;

  static constexpr std::size_t kTurns = 64;  ///< that are remembered

  bool has_time_;
  std::optional<State> first_;
  int direction_ = 0;            ///< of q: 1, −1; 0 before it moved
  State extreme_;                ///< of q since the last turn
  BendNoise noise_;              ///< of q
  Range strain_, strain_since_;  ///< of this half cycle to its extreme of q, and since that
  int turns_ = 0, strain_turns_ = 0;
  int strain_direction_ = 0;
  double strain_extreme_ = 0;
  BendNoise strain_noise_;
  Mean high_, low_;  ///< of the turns
  std::deque<Turn> recent_;
  CyclicLoading found_;
};

}  // namespace triax::lab
