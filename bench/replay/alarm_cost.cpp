// SPDX-License-Identifier: GPL-3.0-or-later
// bench_alarm_cost ROWS [ROUNDS]: what the alarm costs beside the monitor, in processor time. The
// synthetic record, by displacement and undrained: with its noise, where windows are long, and
// without, where every reading is a point of second-order work. Each in turn, the least of ROUNDS.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

#include "bench/replay/synthetic_states.hpp"
#include "lab/collapse/monitor.hpp"
#include "lab/warning/alarm.hpp"

namespace {

using namespace triax;

double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<lab::State> states(long rows, bool with_noise) {
  bench::SyntheticRecord record(rows, with_noise ? 1 : 0);
  std::vector<lab::State> all;
  all.reserve(static_cast<std::size_t>(rows));
  for (long i = 0; i < rows; ++i) all.push_back(bench::reduced(record.row(i), i));
  return all;
}

lab::RecordHeader header_of(const lab::State& state) {
  lab::RecordHeader header;
  header.stages = {{.number = state.stage,
                    .name = "shear",
                    .role = lab::StageRole::shear,
                    .drainage = lab::Drainage::closed,
                    .control = lab::AxialControl::displacement}};
  return header;
}

void watch(const std::vector<lab::State>& all, bool with_alarm) {
  const lab::RecordHeader header = header_of(all.front());
  lab::CollapseMonitor monitor(header);
  lab::Alarm alarm(header);
  for (const lab::State& state : all) {
    monitor.watch(state);
    if (with_alarm) alarm.watch(state);
  }
  monitor.finish();
}

void compare(const char* what, const std::vector<lab::State>& all, int rounds) {
  double alone = std::numeric_limits<double>::infinity(), both = alone;
  for (int i = 0; i < rounds; ++i) {
    const double start = processor_s();
    watch(all, false);
    const double middle = processor_s();
    watch(all, true);
    alone = std::min(alone, middle - start);
    both = std::min(both, processor_s() - middle);
  }
  const double to_ns = 1e9 / static_cast<double>(all.size());
  std::printf("%-46s %6.0f ns %6.0f ns %6.2f\n", what, alone * to_ns, both * to_ns, both / alone);
}

}  // namespace

int main(int argc, char** argv) {
  const long rows = argc > 1 ? std::atol(argv[1]) : 1000000;
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  if (rows < 2 || rounds < 1) return 2;
  std::printf("%-46s %9s %9s %6s\n", "processor time a reading", "monitor", "and alarm", "ratio");
  compare("with noise: windows are long", states(rows, true), rounds);
  compare("without noise: every reading is a point", states(rows, false), rounds);
  return 0;
}
