// SPDX-License-Identifier: GPL-3.0-or-later
// bench_apparatus_memory [--labels] PROGRAMME [DATABASE]: resident memory of this process while a
// test of three days runs at a reading a second, with the database if one is named. Drained shear
// is slowed down until it lasts that long, so that reduction, monitor and recorder work all the
// time. Prints the hours and kB, and fails if the last is above that of a day by more than
// kSlack_kb: until then buffers of fixed size (batches of the recorder, pages of SQLite) are
// touched for the first time.
#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>

#include <cstdio>
#include <fstream>
#include <optional>

#include "bench/point/yardstick.hpp"
#include "db/recording/recorder.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

using namespace triax;

namespace {

constexpr double kHour_s = 3600;
constexpr double kHours[] = {1, 6, 24, 48, 72};
constexpr double kFilled_h = 24;
constexpr long kSlack_kb = 1024;

/// From the kernel's own count, in pages.
long resident_kb() {
  std::ifstream statm("/proc/self/statm");
  long total = 0, resident = 0;
  statm >> total >> resident;
  return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

/// Its drained shear takes days.
lab::Programme slowed(const std::string& file) {
  const std::string text = lab::read_text_file(file);
  const auto stages = lab::read_programme(text, file).stages;
  const auto shear = std::ranges::find(stages, lab::StageRole::shear, &lab::Stage::role);
  const std::string stage = "stages." + std::to_string(shear - stages.begin() + 1);
  return lab::read_programme(text, file,
                             {{"test.scan_interval_s", "1.0"},
                              {stage + ".axial_rate_mm_per_min", "0.0002"},
                              {stage + ".time_limit_min", "100000"}});
}

void print(double hours, long kb) {
  fmt::print("{:>7g} h {:>10} kB\n", hours, bench::timed(static_cast<double>(kb), 0));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  bench::take_labels(argc, argv);
  const std::string file = argc > 1 ? argv[1] : "samples/programmes/csu_26.toml";
  lab::VirtualRig rig(slowed(file));
  lab::SessionListeners listeners;
  std::optional<db::Recorder> recorder;
  if (argc > 2) listeners.push_back(recorder.emplace(argv[2]).listener());
  std::size_t next = 0;
  long filled_kb = 0, last_kb = 0;
  listeners.push_back({.scanned = [&](const lab::Reading& reading, const lab::State&) {
    if (next >= std::size(kHours) || reading.time_s < kHours[next] * kHour_s) return;
    last_kb = resident_kb();
    if (kHours[next] == kFilled_h) filled_kb = last_kb;
    print(kHours[next++], last_kb);
  }});
  // The first hour is enough for the words.
  const auto over = [&] { return next == (bench::only_labels ? 1 : std::size(kHours)); };
  const lab::TestSummary summary = lab::run_session(rig, {.stop = over}, listeners);
  if (recorder) recorder->finish(summary);
  if (bench::only_labels)
    for (; next < std::size(kHours); ++next) print(kHours[next], last_kb);
  if (next < std::size(kHours)) {
    fmt::print(stderr, "the test ended after {} readings\n", summary.readings);
    return 1;
  }
  if (!bench::only_labels && last_kb > filled_kb + kSlack_kb) {
    fmt::print(stderr, "memory grew by {} kB\n", last_kb - filled_kb);
    return 1;
  }
}
