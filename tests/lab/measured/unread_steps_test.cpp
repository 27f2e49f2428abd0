// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/unread_steps.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {

/// A specimen under a growing load: q in kPa over ε₁ in %, one reading a second.
State loaded_state(std::int64_t reading, double strain_pct, double q_kPa) {
  State s;
  s.reading = reading;
  s.time_s = static_cast<double>(reading);
  s.strain = {strain_pct / 100, -strain_pct / 200};
  s.q = q_kPa * 1e3;
  return s;
}

/// After 50 readings of 0.01 % and 1 kPa each, whether the step to this state is unread.
bool unread_after(double strain_pct, double q_kPa, bool has_time = true, double lapse_s = 1) {
  UnreadSteps steps(has_time);
  for (int i = 0; i <= 50; ++i) CHECK_FALSE(steps.add(loaded_state(i, 0.01 * i, i)));
  State last = loaded_state(51, strain_pct, q_kPa);
  last.time_s = 50 + lapse_s;
  return steps.add(last);
}

}  // namespace

TEST_CASE("UnreadSteps: a leap of the strain under a load that does not grow") {
  CHECK(unread_after(8, 49));
  CHECK(unread_after(8, 50));
  CHECK_FALSE(unread_after(0.9, 50));      // below half a per cent
  CHECK_FALSE(unread_after(8, 50 * 1.2));  // a step of the load that it carried
  CHECK_FALSE(unread_after(0.51, 51));
}

TEST_CASE("UnreadSteps: a fall of q between two readings") {
  CHECK(unread_after(0.51, 20));
  CHECK(unread_after(0.51, -20 / 2.0));
  CHECK_FALSE(unread_after(0.51, 45));
  UnreadSteps slow(true);  // a fall that was read
  for (int i = 0; i <= 50; ++i) slow.add(loaded_state(i, 0.01 * i, i));
  for (int i = 1; i <= 20; ++i)
    CHECK_FALSE(slow.add(loaded_state(50 + i, 0.5 + 0.02 * i, 50 - 2 * i)));
}

TEST_CASE("UnreadSteps: a logger that slows down makes no leap") {
  CHECK_FALSE(unread_after(1.1, 50, true, 60));
  CHECK(unread_after(1.1, 50, false, 60));
}

TEST_CASE("UnreadSteps: states without stress are passed over") {
  UnreadSteps steps(true);
  for (int i = 0; i <= 50; ++i) steps.add(loaded_state(i, 0.01 * i, i));
  for (int i = 51; i < 60; ++i) CHECK_FALSE(steps.add(loaded_state(i, 0.01 * i, kMissing)));
  CHECK_FALSE(steps.add(loaded_state(60, 0.6, 60)));
}
