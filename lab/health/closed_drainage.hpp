// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "lab/results/reading.hpp"
#include "lab/results/state.hpp"

namespace triax::lab {

/// Whether a specimen whose drainage is shut by the programme is undrained, from readings alone, in
/// constant memory, by sensor_limits.hpp. Two witnesses, of which one may be dead:
///   the volume V_b of the back-pressure controller stands still,  |V_b − V_b,start| ≤
///   kClosedVolume V the pore pressure leaves the back pressure,                   d = (u − u_b) −
///   (u − u_b)_start
/// A valve is open, or something leaks, where
///   water   V_b moves by more than that: a doubt at once, and for good;
///   return  |d| was kLeft p′_0 or more, came back to kReturned of its largest and rests there, for
///           as long as it took to come back, and kRests readings: through an open valve u
///           comes to u_b and stays, while a specimen that dilates passes it by;
///   silence the mean total stress p = σ_c + q/3 changed by kLoading p′_0 and |d| not by kAnswer of
///           that, nor did it reach kLeft p′_0: a saturated specimen answers with B, of nearly 1.
///           A controller that holds its volume, which then stands still, instead of its pressure
///           goes along with u: there the change of u itself is the answer.
/// The last two are suspicions, known late: if they last until the valve is opened or the record
/// ends, the verdict ends where |d| began to shrink, or where the valve was shut. They are lifted
/// where u leaves the back pressure after all, by kLeaves of its largest |d| or by kLeft p′_0, as
/// through an open valve it does not: a loose specimen with air in its pores contracts by as much
/// as a falling cell pressure lets the air expand, and u rests until it collapses. Where the back
/// pressure is not read its last value stands, the value of u at the start if there was none; p and
/// p′_0 are those of the first reading at which they are known. Slow leaks, which let u build up,
/// only the volume shows.
class ClosedDrainage {
 public:
  struct Doubt {
    std::int64_t last = -1;  ///< last reading at which the specimen was undrained: the one before a
                             ///< mark, or before the water came
    std::string reason;
  };

  /// Volume of the specimen as built; 0: unknown.
  explicit ClosedDrainage(double volume_m3) : volume_m3_(volume_m3) {}

  /// The programme has the valve open; `believed` as below.
  void open();
  /// The programme has it shut; `believed` lacks what cannot be believed, and so does `state`: q
  /// and p′ are NaN where a channel behind them is wrong. Pre-condition: numbers ascend.
  void add(const Reading& believed, const State& state);

  /// V_b was off when it was last read: water, or a stray reading.
  bool wet() const { return wet_ > 0; }
  /// A suspicion that comes later may reach back to just before the last reading.
  bool is_mark() const { return mark_; }
  /// Water shows that the specimen is not undrained; remains until the valve is open.
  const std::optional<Doubt>& doubt() const { return doubt_; }
  /// The pore pressure has it that it is not; may be lifted by readings to come.
  const std::optional<Doubt>& suspicion() const { return returned_ ? returned_ : silent_; }

 private:
  void look_for_water(const Reading& believed);
  void look_at_pore_pressure(const Reading& believed, const State& state);
  void look_for_silence(double total_p);
  void look_for_return(double size, double total_p, std::int64_t number);
  bool is_silent_near(double size, double total_p);

  double volume_m3_;
  bool shut_ = false, mark_ = false;
  std::int64_t before_ = -1;  ///< reading before the last
  std::optional<Doubt> doubt_, returned_, silent_;

  std::optional<int> stage_;
  double start_volume_ = NAN;
  int wet_ = 0;
  std::int64_t dry_until_ = -1;  ///< reading before the first wet one

  double back_ = NAN;  ///< the last that was read
  double start_difference_ = NAN, start_p_ = NAN, start_p_eff_ = NAN;
  std::int64_t start_ = -1;  ///< reading before the first with the valve shut
  bool answered_ = false;
  double largest_ = 0;  ///< of |d|
  double start_pore_ = NAN;
  double largest_alone_ = 0;  ///< of |u − u_start| while the volume that was read stood still
  bool returning_ = false;    ///< |d| fell below kShrinks of the largest, not above kGrows since
  std::int64_t turned_ = -1;  ///< reading before it did
  struct Answer {
    double size = 0, total_p = 0;
  };
  std::optional<Answer>
      near_;  ///< |d| and p since when it does not answer, within kLeaves of the largest
  std::optional<std::int64_t> back_from_;  ///< since when |d| is within kReturned of the largest
};

}  // namespace triax::lab
