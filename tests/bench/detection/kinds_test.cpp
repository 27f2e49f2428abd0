// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/detection/kinds.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <iterator>
#include <sstream>

using namespace triax::bench;

namespace {

const Kind& kind_of(std::string_view name, std::string_view part_of_programme) {
  const auto all = kinds();
  return *std::ranges::find_if(all, [&](const Kind& kind) {
    return kind.name == name && kind.programme.find(part_of_programme) != std::string_view::npos;
  });
}

/// A test that collapsed at η 0.6 and was found there with an error.
TrialResult found(std::string_view kind, double error, std::optional<double> half_width) {
  TrialResult r;
  r.trait = kind;
  r.collapses = r.truth_lost = true;
  r.truth_eta = 0.6;
  r.truth_q_pa = 60e3;
  r.truth_p_pa = 100e3;
  r.outcomes[0] = {
      .collapses = true, .detected = true, .eta_error = error, .delay = 3, .notice_delay = {}};
  if (half_width)
    r.interval = triax::lab::StressInterval{
        {59e3, 61e3}, {101e3, 102e3}, {0.6 + error - *half_width, 0.6 + error + *half_width}};
  return r;
}

std::vector<std::string> words_of_line(const std::string& table, std::string_view beginning) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(beginning)) continue;
    std::istringstream rest(line.substr(beginning.size()));
    return {std::istream_iterator<std::string>(rest), {}};
  }
  return {};
}

}  // namespace

TEST_CASE("coverage counts the tests whose interval holds the truth, of those that have one") {
  const std::string_view name = kinds().front().name;
  const auto words = words_of_line(
      table_of_kinds({found(name, 0.01, 0.02), found(name, 0.03, 0.02), found(name, 0.02, {})}),
      name);
  // tests, found, three errors, three delays, never, two widths, eta, q, p', without an interval
  REQUIRE(words.size() == 15);
  CHECK(words[0] == "3");
  CHECK(words[1] == "100.0");
  CHECK(words[2] == "0.0200");
  CHECK(words[4] == "0.0300");
  CHECK(words[8] == "3");  // nothing was noticed
  CHECK(words[9] == "0.0200");
  CHECK(words[11] == "50.0");
  CHECK(words[12] == "100.0");
  CHECK(words[13] == "0.0");
  CHECK(words[14] == "1");
}

TEST_CASE("a cheap test is judged, with an interval, and ends the same whenever it is run") {
  const Kind& kind = kind_of("12 bits, 0.5 kPa", "icu_load");
  const TrialResult one = run_kind(kind, 3), two = run_kind(kind, 3);
  CHECK(one.trait == kind.name);
  CHECK(one.truth_lost);
  REQUIRE(one.interval);
  CHECK(one.interval->eta.low == two.interval->eta.low);
}

TEST_CASE("a record that ends in the fall ends soon after its truth") {
  const TrialResult cut = run_kind(kind_of("ends in the fall", "icu_6"), 2);
  const TrialResult whole = run_kind(kind_of("standard instruments", "icu_6"), 2);
  CHECK(cut.truth_reading == whole.truth_reading);
  CHECK(cut.readings < whole.readings);
  CHECK(cut.readings > cut.truth_reading);
}
