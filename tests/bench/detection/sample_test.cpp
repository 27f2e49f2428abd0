// SPDX-License-Identifier: GPL-3.0-or-later
// A fixed sample of bench/detection, held to the benchmark's own bounds: every subject of its list
// once, and those that are led by a constant shear or a strain path a second time with another
// seed.
#include <catch2/catch.hpp>

#include "bench/detection/subjects.hpp"
#include "bench/detection/table.hpp"

using namespace triax;

TEST_CASE(
    "detection, false alarms, delay and error of eta hold the benchmark's bounds on a fixed sample",
    "[slow]") {
  const auto subjects =
      bench::read_subjects("bench/detection/programmes.txt", "samples/programmes");
  std::vector<bench::TrialResult> results;
  for (const bench::Subject& subject : subjects) {
    results.push_back(bench::run_trial(subject, 1));
    const std::string& type = subject.programme.type;
    if (subject.collapses && (type == "CSD" || type == "CSU" || type == "SP"))
      results.push_back(bench::run_trial(subject, 2));
  }
  INFO(bench::table(results));
  // The least number of tests is the sample's own; the other bounds are the benchmark's.
  bench::Bounds bounds;
  bounds.tests = 35;
  const std::vector<std::string> faults = bench::broken(results, bounds, true);
  for (const std::string& fault : faults) FAIL_CHECK(fault);
  CHECK(faults.empty());
  const auto controls = std::ranges::count(results, false, &bench::TrialResult::collapses);
  CHECK(controls >= 12);
}
