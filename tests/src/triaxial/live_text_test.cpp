// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/live_text.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "src/output/table.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using Catch::Contains;

namespace {

lab::Forecast forecast(lab::Quantity quantity, double left) {
  return {.reading = 1234567,
          .time_s = 9000.0,
          .eta = 0.594,
          .eta_low = 0.559,
          .eta_high = 0.629,
          .left = lab::LeftToOnset{quantity, left, 3764.0}};
}

/// Wherever lines are broken.
std::string flat(const std::string& text) {
  std::istringstream words(text);
  std::string all;
  for (std::string word; words >> word;) all += word + ' ';
  return all;
}

study::LiveAccount account() {
  using enum lab::EventKind;
  study::LiveAccount a;
  a.forecasts = 64;
  const lab::Moment at{1234567, 9000.0};
  const auto with = [&](lab::EventKind kind, std::optional<lab::Forecast> f) {
    return study::LiveRow{at, 12, -0.516, lab::Event{1234567, 9000.0, kind, "why", at}, f};
  };
  a.rows = {with(stage_started, {}),
            {at, 12, 0.5, {}, forecast(lab::Quantity::deviator_stress, 1234567)},
            with(approaching, forecast(lab::Quantity::mean_effective_stress, 1234567)),
            with(imminent, forecast(lab::Quantity::axial_strain, 0.00059)),
            with(imminent, forecast(lab::Quantity::axial_strain, 0)),
            with(warning_withdrawn, {}),
            {lab::Moment{1234600, 9100.0},
             12,
             0.7,
             lab::Event{300, 30, loss_of_sustainability, "fell", {}},
             {}},
            {{}, {}, {}, lab::Event{310, 31, limit_surface, "came to light late", {}}, {}}};
  a.shown = 1;
  return a;
}

}  // namespace

TEST_CASE("what was said stands in lines of a hundred columns, with units and words") {
  auto test = src::test::flow_test().stored;
  test.events = {{1, 1, lab::EventKind::approaching, "", {}},
                 {2, 2, lab::EventKind::warning_withdrawn, "", {}}};
  study::LiveAccount a = account();
  a.onset = test.summary.collapse.onset;
  test.summary.collapse.onset_detected_at = lab::Moment{330, 33.0};
  test.summary.collapse.imminent = forecast(lab::Quantity::axial_strain, 0.00059);
  a.imminent = study::LiveLead{*test.summary.collapse.imminent, 10, 1.0};
  const std::string text = src::live_text(test, a);
  INFO(text);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) CHECK(src::display_width(line) <= 100);
  for (const char* words :
       {"1234.57 kPa of q", "1234.57 kPa of p′", "0.059 % of ε₁", "none: passed", "62.7 min",
        "0.559 to 0.629", "approaching", "imminent", "withdrawn", "lost", "failure", " end ",
        "begins", "at reading 300: fell", "1 of 64 forecasts are shown",
        "issued once and withdrawn",
        "10 readings and 1.0 s before the onset; η forecast 0.594 (0.559 to 0.629), 0.006 too low",
        "detected at reading 330, 30 readings and 3.0 s after the onset"})
    CHECK_THAT(flat(text), Contains(words));
}

TEST_CASE("silence is told, and a level that stood for nothing") {
  const auto test = src::test::stable_test().stored;
  study::LiveAccount a;
  CHECK_THAT(flat(src::live_text(test, a)), Contains("never issued") &&
                                                Contains("No onset was forecast") &&
                                                Contains("no onset was found"));
  auto warned = test;
  warned.summary.collapse.approaching = forecast(lab::Quantity::axial_strain, 0.00059);
  CHECK_THAT(flat(src::live_text(warned, a)), Contains("not withdrawn; no onset was found"));
}
