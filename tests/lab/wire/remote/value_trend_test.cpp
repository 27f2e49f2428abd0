// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms of interval and tolerance.
#include "lab/wire/remote/value_trend.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>
#include <limits>

using triax::lab::ValueTrend;

namespace {

constexpr double kEnd = std::numeric_limits<double>::infinity();

ValueTrend trend_of(std::initializer_list<double> values) {
  ValueTrend trend;
  for (const double value : values) trend.accept(value);
  return trend;
}

}  // namespace

TEST_CASE("ValueTrend: expects nothing before the first value") {
  CHECK_FALSE(ValueTrend().expects(0));
  CHECK_FALSE(ValueTrend().value());
}

TEST_CASE("ValueTrend: expects a value between the last and the next step") {
  const ValueTrend trend = trend_of({0, 1});
  CHECK(trend.value() == 1);
  for (const double expected : {1.0, 1.5, 2.0}) CHECK(trend.expects(expected));
  for (const double unexpected : {0.999, 2.001}) CHECK_FALSE(trend.expects(unexpected));
}

TEST_CASE("ValueTrend: the interval widens with each missing scan, up to a limit") {
  ValueTrend trend = trend_of({0, 1});
  trend.miss();
  CHECK(trend.expects(3));
  CHECK_FALSE(trend.expects(3.001));
  for (int i = 2; i < ValueTrend::kMaxScans; ++i) trend.miss();
  CHECK(trend.expects(1));
  trend.miss();
  CHECK_FALSE(trend.expects(1));
}

TEST_CASE("ValueTrend: the tolerance is twice the third largest distance") {
  // Each turn of +1, -1 is 2 away from the interval [1, 3].
  const ValueTrend trend = trend_of({1, -1, 1, -1, 1});
  CHECK(trend.expects(-3));
  CHECK_FALSE(trend.expects(-3.001));
}

TEST_CASE("ValueTrend: one step does not widen the tolerance") {
  const ValueTrend trend = trend_of({100, 100, 100, 200, 200, 200});
  CHECK(trend.expects(200));
  CHECK_FALSE(trend.expects(200.001));
}

TEST_CASE("ValueTrend: start gives the first values room for their noise") {
  ValueTrend trend;
  trend.start(100, 0.5);
  CHECK(trend.expects(102));
  CHECK_FALSE(trend.expects(102.001));
}

TEST_CASE("ValueTrend: confirms a reply nearer to the one before than to the trend") {
  const ValueTrend trend = trend_of({100, 100});
  CHECK(trend.confirms(200, 200));
  CHECK(trend.confirms(200, 151));
  CHECK_FALSE(trend.confirms(200, 149));
  CHECK_FALSE(trend.confirms(3005, 30.5));
}

TEST_CASE("ValueTrend: the end of the range is confirmed in both directions") {
  ValueTrend trend = trend_of({100, 100});
  CHECK_FALSE(trend.expects(kEnd));
  CHECK_FALSE(trend.confirms(kEnd, 100));
  CHECK(trend.confirms(kEnd, kEnd));
  trend.accept(kEnd);
  CHECK(trend.expects(kEnd));
  CHECK_FALSE(trend.expects(-kEnd));
  CHECK_FALSE(trend.expects(100));
  CHECK(trend.confirms(100, 100));
}
