// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/devices/faulty_channel.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax;
using namespace triax::lab;

namespace {
Transducer in_kPa(double range = 1000, double step = 0) {
  Transducer t;
  t.unit = *sim::find_unit("kPa");
  t.range = range;
  t.step = step;
  return t;
}
Fault fault(FaultKind kind, double from_s, std::optional<double> until_s = {}, double size = 0) {
  return {
      .device = "pore_pressure", .kind = kind, .from_s = from_s, .until_s = until_s, .size = size};
}
FaultyChannel channel(std::vector<Fault> faults, const Transducer& t = in_kPa()) {
  return {std::move(faults), t, 7, 4};
}
/// Of a signal of 1 kPa/s at that second.
double signal_pa(int second) { return 1e3 * second; }
}  // namespace

TEST_CASE("a channel without an active fault passes to the bit") {
  auto healthy = channel({});
  auto later = channel({fault(FaultKind::stuck, 100), fault(FaultKind::drift, 100, {}, 5),
                        fault(FaultKind::latency, 100, {}, 3)});
  for (const double si : {123456.789, -1e-3, 5e5 / 3}) {
    CHECK(healthy.pass(si, 1) == si);
    CHECK(later.pass(si, 2) == si);
    CHECK_FALSE(later.saturated());
  }
}

TEST_CASE("a stuck channel repeats the value given before") {
  auto c = channel({fault(FaultKind::stuck, 3, 6)});
  const std::vector<double> wanted{0, 1e3, 2e3, 2e3, 2e3, 2e3, 6e3, 7e3};
  for (int i = 0; i < 8; ++i) CHECK(c.pass(signal_pa(i), i) == wanted[static_cast<std::size_t>(i)]);
}

TEST_CASE("stuck from the first reading on it stays there") {
  auto c = channel({fault(FaultKind::stuck, 0)});
  for (int i = 0; i < 5; ++i) CHECK(c.pass(signal_pa(i + 7), i) == 7e3);
}

TEST_CASE("an open circuit reads the end of the range and says so") {
  auto c = channel({fault(FaultKind::open_circuit, 2, 3)});
  c.pass(1e3, 1);
  CHECK_FALSE(c.saturated());
  CHECK(c.pass(1e3, 2) == 1000e3);
  CHECK(c.saturated());
  CHECK(c.pass(1e3, 3) == 1e3);
  CHECK_FALSE(c.saturated());
  auto unlimited = channel({fault(FaultKind::open_circuit, 0)}, in_kPa(0));
  CHECK(std::isnan(unlimited.pass(1e3, 1)));
}

TEST_CASE("a drop-out gives no readings and nothing of it stays") {
  auto c = channel({fault(FaultKind::drop_out, 2, 4)});
  for (int i = 0; i < 6; ++i) CHECK(std::isnan(c.pass(signal_pa(i), i)) == (i == 2 || i == 3));
}

TEST_CASE("a drift grows from its begin, on the steps of the converter, up to the range") {
  auto c = channel({fault(FaultKind::drift, 10, {}, 1700)}, in_kPa(1000, 1));
  CHECK(c.pass(500e3, 9) == 500e3);
  CHECK(c.pass(500e3, 10) == 500e3);
  CHECK(c.pass(500e3, 11) == 502e3);
  CHECK(c.pass(500e3, 12) == 503e3);
  CHECK(c.pass(500e3, 10000) == 1000e3);
  CHECK(c.saturated());
}

TEST_CASE("spikes are one reading in 32, of either sign, the same for the same seed") {
  auto c = channel({fault(FaultKind::spike, 0, {}, 20e3)});
  auto same = channel({fault(FaultKind::spike, 0, {}, 20e3)});
  FaultyChannel other({fault(FaultKind::spike, 0, {}, 20e3)}, in_kPa(), 8, 4);
  int up = 0, down = 0, in_block = 0, different = 0;
  for (int i = 0; i < 3200; ++i) {
    const double si = c.pass(500e3, i);
    CHECK(same.pass(500e3, i) == si);
    different += other.pass(500e3, i) != si ? 1 : 0;
    if (i % 32 == 0) in_block = 0;
    if (si != 500e3) {
      ++in_block;
      CHECK(std::abs(si - 500e3) == Approx(20e3));
      ++(si > 500e3 ? up : down);
    }
    if (i % 32 == 31) CHECK(in_block == 1);
  }
  CHECK(up + down == 100);
  CHECK(up > 30);
  CHECK(down > 30);
  CHECK(different > 100);
}

TEST_CASE("latency gives what there was before, from before the fault too") {
  auto c = channel({fault(FaultKind::latency, 10, 20, 4)});
  for (int i = 0; i < 30; ++i)
    CHECK(c.pass(signal_pa(i), i) == signal_pa(i >= 10 && i < 20 ? i - 4 : i));
}

TEST_CASE("latency waits for the oldest where nothing older is known") {
  auto c = channel({fault(FaultKind::latency, 0, {}, 4)});
  for (int i = 0; i < 4; ++i) CHECK(c.pass(signal_pa(i), i) == 0);
  CHECK(c.pass(signal_pa(5), 5) == signal_pa(1));
}

TEST_CASE("a latency of 60 readings is exact, one of more calls is kept to a sixtieth") {
  auto c = channel({fault(FaultKind::latency, 0, {}, 60)});
  auto often = channel({fault(FaultKind::latency, 0, {}, 60)});
  for (int i = 0; i <= 300; ++i) {
    const double si = c.pass(signal_pa(i), i);
    if (i >= 60) CHECK(si == signal_pa(i - 60));
    for (int k = 0; k < 10; ++k) {
      const double time_s = i + 0.1 * k;
      const double late_s = time_s - often.pass(1e3 * time_s, time_s) / 1e3;
      if (i >= 60) CHECK((late_s >= 60 - 1e-6 && late_s <= 61 + 1e-6));
    }
  }
}

TEST_CASE("faults in pairs: the one nearer to the record wins") {
  auto stuck_late = channel({fault(FaultKind::latency, 0, {}, 2), fault(FaultKind::stuck, 5)});
  for (int i = 0; i < 5; ++i) stuck_late.pass(signal_pa(i), i);
  CHECK(stuck_late.pass(signal_pa(5), 5) == signal_pa(2));
  auto open_stuck = channel({fault(FaultKind::open_circuit, 3), fault(FaultKind::stuck, 5)});
  for (int i = 0; i < 5; ++i) open_stuck.pass(signal_pa(i), i);
  CHECK(open_stuck.pass(signal_pa(5), 5) == 1000e3);
  auto dropped = channel({fault(FaultKind::stuck, 0), fault(FaultKind::drop_out, 1)});
  dropped.pass(1, 0);
  CHECK(std::isnan(dropped.pass(2, 1)));
}

TEST_CASE("a copied channel goes on like its original") {
  auto c = channel({fault(FaultKind::spike, 0, {}, 5e3), fault(FaultKind::latency, 3, {}, 2)});
  for (int i = 0; i < 40; ++i) c.pass(signal_pa(i), i);
  auto copy = c;
  for (int i = 40; i < 120; ++i) CHECK(copy.pass(signal_pa(i), i) == c.pass(signal_pa(i), i));
  CHECK(copy.state() == c.state());
}
