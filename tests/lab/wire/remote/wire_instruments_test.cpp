// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/wire_instruments.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <limits>
#include <thread>

#include "tests/lab/wire/served_bench.hpp"

using namespace triax::lab;
using namespace triax::lab::test;

namespace {

constexpr double kShortDeadline_s = 0.3;

/// The instruments of a bench, connected.
struct ConnectedBench {
  ServedBench bench{read_programme(programme_text(), "p.toml"), rig_text(), {.lock_step = true}};
  RigFile rig = with_short_deadlines(bench.client);
  LineLoop loop;
  WireInstruments instruments{loop, rig, [](const auto&) { return std::vector<std::string>(); }};
  ConnectedBench() { REQUIRE(instruments.connect(2, {}).empty()); }

  static RigFile with_short_deadlines(RigFile rig) {
    for (RigInstrument& one : rig.instruments) one.personality.deadline_s = kShortDeadline_s;
    return rig;
  }
};

/// As a process that stands still: no handler runs.
void stand_still(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

TEST_CASE("WireInstruments::scan: waits for what it asked after a stall", "[wire][scan]") {
  ConnectedBench rig;
  std::vector<std::string> causes;
  int asked = 0;
  const auto stall_before_second = [&](const WireInstrument&) {
    if (++asked == 2) stand_still(kShortDeadline_s + 1.2);
    return std::numeric_limits<double>::infinity();
  };
  const auto take = [&causes](const WireInstrument&, const WireInstrument::Scan& scan) {
    causes.push_back(scan.why);
  };
  rig.instruments.scan(take, stall_before_second);
  // None was read within its deadline from the instant of the scan on; of the frame nothing is
  // read.
  const std::string late = "no response within 0.3 s";
  CHECK(causes == std::vector<std::string>{"", late, late, late});
  rig.loop.run_for(0.2);
  CHECK(causes.size() == 4);
  causes.clear();
  rig.instruments.scan(take);
  CHECK(causes == std::vector<std::string>(4));
}

TEST_CASE("WireInstruments::scan: no handler is called after it has thrown", "[wire][scan]") {
  ConnectedBench rig;
  {
    const auto calls = std::make_unique<int>(0);
    CHECK_THROWS_AS(rig.instruments.scan([&calls](const auto&, const auto&) {
      if (++*calls > 1) FAIL("called after it has thrown");
      throw std::runtime_error("first");
    }),
                    std::runtime_error);
  }
  rig.loop.run_for(0.2);
  int answers = 0;
  rig.instruments.scan([&answers](const auto&, const auto&) { ++answers; });
  CHECK(answers == 4);
}
