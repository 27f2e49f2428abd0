// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/reduction/rate_check.hpp"

#include <catch2/catch.hpp>

#include "tests/lab/reduction/raw_record.hpp"

using namespace triax::lab;

namespace {

/// u stands `lag_kPa` above the back pressure of 300 kPa, p' is 100 kPa.
void add(RateCheck& rate, std::int64_t i, double lag_kPa, bool shear = true,
         std::optional<double> rest_kPa = 0) {
  Reading r = triax::lab::testing::reading({3, 0, 0, 400, 300 + lag_kPa, 0}, i);
  r[Quantity::back_pressure] = 300e3;
  State s;
  s.reading = i;
  s.p_eff = 100e3;
  rate.add(r, s, shear, rest_kPa ? std::optional(*rest_kPa * 1e3) : std::nullopt);
}

}  // namespace

TEST_CASE("the largest lag over p' is measured, of means") {
  RateCheck rate;
  for (int i = 0; i < 160; ++i) add(rate, i, 3 + (i % 2 ? 20 : -20));  // noise averages out
  const auto check = rate.check({});
  REQUIRE(check);
  CHECK(*check->measured == Approx(0.03));
  CHECK(check->ok);
}

TEST_CASE("a lag that is too large fails with reading, size and sign") {
  RateCheck rate;
  for (int i = 0; i < 320; ++i) add(rate, i, i < 160 ? -1 : -8);
  const auto check = rate.check({});
  REQUIRE(check);
  CHECK_FALSE(check->ok);
  CHECK(*check->measured == Approx(0.08));
  CHECK(check->note.find("at reading 175 the pore pressure was 8.00 kPa below") !=
        std::string::npos);
}

TEST_CASE("RateCheck: without consolidation the first reading is at rest") {
  RateCheck zero;
  for (int i = 0; i < 160; ++i) add(zero, i, 12, true, {});  // of the two transducers
  CHECK(zero.check({})->ok);
  RateCheck lag;
  for (int i = 0; i < 160; ++i) add(lag, i, i < 16 ? 0 : 12, true, {});
  CHECK_FALSE(lag.check({})->ok);
}

TEST_CASE("only what came before the onset of collapse counts") {
  RateCheck rate;
  for (int i = 0; i < 1000; ++i) add(rate, i, i < 500 ? 0.004 * i : 60);
  CHECK_FALSE(rate.check({})->ok);
  const auto before = rate.check(496);
  REQUIRE(before);
  CHECK(before->ok);
  // Maxima are kept where they grew by 8 %.
  CHECK(*before->measured == Approx(0.0195).epsilon(0.09));
  CHECK_FALSE(rate.check(10));
}

TEST_CASE(
    "what stood between the two at rest is taken off; without drained shear nothing is said") {
  RateCheck rate;
  for (int i = 0; i < 100; ++i) add(rate, i, 7, true, 6);
  CHECK(*rate.check({})->measured == Approx(0.01));
  RateCheck none;
  for (int i = 0; i < 100; ++i) add(none, i, 7, false);
  CHECK_FALSE(none.check({}));
}

TEST_CASE("a missing transducer is no lag") {
  RateCheck rate;
  for (int i = 0; i < 100; ++i) add(rate, i, i < 50 ? 1 : kMissing);
  CHECK(*rate.check({})->measured == Approx(0.01));
}
