// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/table.hpp"

#include <catch2/catch.hpp>

using namespace triax::bench;

namespace {

TrialResult result(bool collapses, bool truth_lost, bool detected, std::int64_t delay = 0) {
  TrialResult r;
  r.type = "ICU";
  r.collapses = collapses;
  r.truth_lost = truth_lost;
  for (Outcome& o : r.outcomes) {
    o = {.collapses = collapses, .detected = detected};
    if (detected && collapses) {
      o.eta_error = 0.001;
      o.delay = delay;
    }
  }
  return r;
}

bool mentions(const std::vector<std::string>& sentences, const std::string& what) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& s) { return s.find(what) != std::string::npos; });
}

}  // namespace

TEST_CASE("bounds: each is found where it is broken, and only there") {
  std::vector<TrialResult> good(100, result(true, true, true, 5));
  good.insert(good.end(), 100, result(false, false, false));
  CHECK(broken(good, {}, false).empty());
  CHECK(mentions(broken(good, {}, true), "200 tests"));

  auto missed = good;
  missed[0] = result(true, true, false);
  CHECK(broken(missed, {}, false).size() == 1);
  CHECK(mentions(broken(missed, {}, false), "99.00 % detected"));

  auto alarmed = good;
  alarmed[150] = result(false, false, true);
  CHECK(mentions(broken(alarmed, {}, false), "1.00 % false alarms"));

  auto late = good;
  for (int i = 0; i < 6; ++i) late[std::size_t(i)] = result(true, true, true, -6);
  CHECK(mentions(broken(late, {}, false), "delay 6 readings"));
}

TEST_CASE("a specimen that did not collapse where it was to is told of and left out") {
  std::vector<TrialResult> results(3, result(true, true, true));
  results.push_back(result(true, false, false));
  CHECK(broken(results, {}, false).empty());
  CHECK(table(results).find("1 specimens did not collapse") != std::string::npos);
}

TEST_CASE("the CSV has a line a test and method, unknown values empty") {
  const std::string text = csv({result(true, true, true), result(false, false, false)});
  CHECK(std::count(text.begin(), text.end(), '\n') == 1 + 2 * std::ptrdiff_t(kMethods.size()));
  CHECK(text.find(",stable,false,,,") != std::string::npos);
}
