// SPDX-License-Identifier: GPL-3.0-or-later
// Codes and dropouts of one channel, in every form of record, at every place: a test that hardens
// is never reported as a collapse, and no impossible state goes without a warning.
#include "tests/lab/health/spoiled_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <iostream>

#include "lab/base/byte_source.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"

using namespace triax::lab;
using namespace triax::lab::testing;

namespace {

struct Outcome {
  Collapse collapse;
  std::vector<std::string> warnings;
  bool impossible = false;  ///< a state with p' or the smaller effective stress below -6 kPa
  std::string error;
};

Outcome replay(const Sheet& sheet) {
  Outcome out;
  try {
    RecordedRig rig(open_memory("g.csv", sheet.text()), {}, "", "");
    const SessionListener states{.scanned = [&](const Reading&, const State& s) {
      const double least = s.p_eff - (s.q >= 0 ? s.q / 3 : -2 * s.q / 3);
      out.impossible = out.impossible || s.p_eff < -6e3 || least < -6e3;
    }};
    const TestSummary summary = run_session(rig, {}, {states});
    out.collapse = summary.collapse;
    for (const auto* list : {&rig.header().warnings, &summary.warnings})
      for (const Warning& w : *list) out.warnings.push_back(w.text);
  } catch (const std::exception& error) {
    out.error = error.what();
  }
  return out;
}

bool tells_of_a_value(const Outcome& out) {
  return std::ranges::any_of(out.warnings, [](const std::string& text) {
    for (const char* word : {"no value", "spike", "impossible", "unknown", "gives no readings",
                             "stuck", "saturated", "not assessed"})
      if (text.find(word) != std::string::npos) return true;
    return false;
  });
}

const std::vector<std::string> kColumns{"raw", "q p'", "s1' s3'", "q u", "all"};
const std::vector<RecordForm> kShapes{{"", 24, 0.12, true},       {"", 24, 0.05, false},
                                      {"", 60, 0.10, true},       {"", 60, 0.10, false, 1e-3},
                                      {"", 160, 0.10, true},      {"", 160, 0.12, false},
                                      {"", 160, 0.12, true, 1e-3}};
const std::vector<std::string> kCodes{"-9999", "-999.25", "9999",   "99999", "1e30", "9.9E37",
                                      "6999",  "7999",    "-32768", "32767", "-999", "3.4028235e38",
                                      "0",     "0",       "x2.5",   "x2.5",  "x1.3", "0"};

struct Numbers {
  int records = 0, collapses = 0, silent = 0, errors = 0, judged = 0;
};

/// Records of all kinds in turn, drawn at random by `seed`.
Numbers spoil_many(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto draw = [&](const auto& list) -> const auto& { return list[random() % list.size()]; };
  Numbers n;
  for (; n.records < count; ++n.records) {
    RecordForm form = draw(kShapes);
    form.columns = draw(kColumns);
    const ClosedFormTest& test = draw(hardening_tests());
    Sheet sheet = write_sheet(test, form, random);
    const std::size_t column = draw(sheet.channels);
    constexpr std::array kCells{1, 1, 2, 3, 10};
    constexpr std::array kPlaces{0.0, 0.04, 0.1, 0.25, 0.5, 0.75, 0.97, 1.0};
    const Spoiler spoiler{draw(kCodes), draw(kPlaces), draw(kCells)};
    const std::size_t row = spoil(sheet, column, spoiler);
    const Outcome out = replay(sheet);
    const bool silent = out.impossible && !tells_of_a_value(out);
    if (out.collapse.detected() || silent || !out.error.empty())
      std::cout << fmt::format(
          "{} readings of '{}' in {} ({}, {}) from row {} of {}, noise {}: {}{}{}\n", spoiler.cells,
          spoiler.code, sheet.headings[column], form.columns, test.name, row, form.readings,
          form.noise, to_string(out.collapse.kind), silent ? " silent" : "", out.error);
    n.collapses += out.collapse.detected() ? 1 : 0;
    n.silent += silent ? 1 : 0;
    n.errors += out.error.empty() ? 0 : 1;
    n.judged += out.collapse.judged && !out.collapse.judged_until ? 1 : 0;
  }
  return n;
}

}  // namespace

TEST_CASE("run_session: clean records harden, and nothing is said of values", "[health]") {
  std::mt19937 random(1);
  for (const std::string& columns : kColumns)
    for (RecordForm form : kShapes)
      for (const ClosedFormTest& test : hardening_tests()) {
        form.columns = columns;
        const Outcome out = replay(write_sheet(test, form, random));
        INFO(columns << ", " << test.name << ", " << form.readings << " readings, noise "
                     << form.noise << ": " << out.error
                     << fmt::format("{}", fmt::join(out.warnings, "\n")));
        CHECK(out.error.empty());
        CHECK_FALSE(out.collapse.detected());
        CHECK(out.collapse.judged);
        CHECK_FALSE(out.collapse.judged_until);
        CHECK_FALSE(tells_of_a_value(out));
      }
}

TEST_CASE("run_session: codes and dropouts are no collapse", "[health]") {
  const Numbers n = spoil_many(400, 1);
  CHECK(n.collapses == 0);
  CHECK(n.silent == 0);
  CHECK(n.errors == 0);
  CHECK(n.judged > 250);
}

TEST_CASE("run_session: codes and dropouts in many records", "[.spoiled]") {
  const Numbers n = spoil_many(6000, 1001);
  std::cout << fmt::format("{} records, {} collapses, {} silent, {} errors, {} judged to the end\n",
                           n.records, n.collapses, n.silent, n.errors, n.judged);
  // 7 of 6,000: three zeros of q in a record of 24 readings, and six times one or two readings that
  // are scaled by 1.3 or 2.5 in the first rows, where a jump cannot be distinguished from a curve.
  CHECK(n.collapses * 500 < n.records);
  CHECK(n.silent + n.errors == 0);
}

TEST_CASE("run_session: a collapse is found beside codes and dropouts", "[health]") {
  std::mt19937 random(2);
  for (const std::string& columns : kColumns)
    for (const double where : {-1.0, 0.02, 0.5, 0.9}) {
      RecordForm form{columns, 160, 0.12, true};
      Sheet sheet = write_sheet(collapsing_tests().front(), form, random);
      if (where >= 0) spoil(sheet, sheet.channels.back(), {"-9999", where, 2});
      const Outcome out = replay(sheet);
      INFO(columns << " from " << where << ": " << out.error
                   << fmt::format("{}", fmt::join(out.warnings, "\n")));
      CHECK(out.collapse.detected());
      REQUIRE(out.collapse.onset);
      CHECK(*out.collapse.onset->axial_strain == Approx(0.01).margin(0.003));
    }
}

TEST_CASE("run_session: liquefaction is judged until p' is below zero and its error", "[health]") {
  Sheet sheet;
  sheet.headings = {"time_s", "axial_strain_pct", "deviator_stress_kPa",
                    "mean_effective_stress_kPa"};
  const auto p_at = [](int i) { return i < 60 ? 100 - 1.6 * i : i < 90 ? 4 - 0.1 * i + 5 : -12.0; };
  for (int i = 0; i < 120; ++i)
    sheet.rows.push_back(
        {fmt::format("{}", i), fmt::format("{:.3f}", 0.05 * i),
         fmt::format("{:.3f}", i < 30 ? 1.5 * i : std::max(0.2, 45 - 1.5 * (i - 30))),
         fmt::format("{:.3f}", p_at(i))});
  const Outcome out = replay(sheet);
  INFO(out.error << fmt::format("{}", fmt::join(out.warnings, "\n")));
  CHECK(out.collapse.detected());
  CHECK(out.collapse.judged_until == 89);
  CHECK(tells_of_a_value(out));
}
