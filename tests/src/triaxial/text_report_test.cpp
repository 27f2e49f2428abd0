// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/text_report.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "src/output/table.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax::src;
using namespace triax::study;

namespace {

/// Wherever lines are broken.
bool holds(const std::string& text, const std::string& part) {
  std::istringstream words(text);
  std::string flat;
  for (std::string word; words >> word;) flat += (flat.empty() ? "" : " ") + word;
  return flat.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the summary lines up and says what Table 2 says") {
  const std::string text =
      text_report({test::flow_test(), test::simulated_test(), test::stable_test()});
  std::istringstream lines(text);
  std::string heading, first;
  std::getline(lines, heading);  // of two lines where the terminal is narrow, as it is here
  while (std::getline(lines, first) && !first.starts_with("---")) continue;
  std::getline(lines, first);
  for (const char* column : {"Type of", "Test", "p′₀ (kPa)", "e₀", "φ_mob (°)", "η_coll"})
    CHECK(holds(heading, column));
  // η_coll ends where its column ends, although the headings before it hold wide UTF-8.
  const auto end_of = [](const std::string& line, const std::string& word) {
    return display_width(line.substr(0, line.find(word) + word.size()));
  };
  CHECK(end_of(heading, "η_coll") == end_of(first, "0.60"));
  CHECK(holds(first, "15.83"));
  CHECK(holds(first, "1.086"));
}

TEST_CASE("each test says its evidence, its doubts and that it is simulated or interrupted") {
  const std::string flow = text_of_test(test::flow_test());
  CHECK(holds(flow, "flow"));
  CHECK(holds(flow, "inside the Mohr-Coulomb limit surface"));
  CHECK(holds(flow, "negative beyond 3 standard errors"));
  CHECK(holds(flow, "line 12: missing cell"));
  CHECK_FALSE(holds(flow, "SIMULATED"));
  const std::string simulated = text_of_test(test::simulated_test());
  CHECK(holds(simulated, "SIMULATED"));
  CHECK(holds(simulated, "True onset (model)"));
  CHECK(holds(text_of_test(test::interrupted_test()), "INTERRUPTED"));
  auto blind = test::stable_test();
  blind.stored.summary.collapse.judged = false;
  CHECK(holds(text_of_test(blind), "not assessed"));
  CHECK_FALSE(holds(text_of_test(blind), "stayed controllable"));
  auto leapt = test::stable_test();
  CHECK(holds(text_of_test(leapt), "stayed controllable"));
  leapt.stored.summary.collapse.criteria.push_back(
      {.name = "loss_of_control", .detected = false, .reading = 77, .evidence = "jumped"});
  CHECK_FALSE(holds(text_of_test(leapt), "stayed controllable"));
  CHECK(holds(text_of_test(leapt), "a runaway at reading 77"));
}

TEST_CASE("beside an onset stands where it lies with 95 %, and when it was known") {
  auto test = test::flow_test();
  CHECK(holds(text_report({test}), "detected only when the record had ended"));
  CHECK(holds(text_report({test}), "Loss of control none"));
  auto& collapse = test.stored.summary.collapse;
  collapse.onset->interval = {{58e3, 61e3}, {96e3, 104e3}, {0.57, 0.62}};
  collapse.onset_detected_at = triax::lab::Moment{330, 33.0};
  collapse.criteria[0].detected_at = triax::lab::Moment{340, std::nullopt};
  test.stored.events = {{301, 30.1, triax::lab::EventKind::loss_of_sustainability, "q fell away",
                         triax::lab::Moment{335, 33.5}}};
  const std::string text = text_report({test});
  CHECK(holds(text, "loss of sustainability 301 30.1 s 335 33.5 s q fell away"));
  CHECK(holds(text, "with 95 %: η 0.570 to 0.620, q 58.0 to 61.0 kPa, p′ 96.0 to 104.0 kPa"));
  CHECK(holds(text, "detected at reading 330, 33.0 s; 30 readings later"));
  CHECK(holds(text, "340"));
}

TEST_CASE("text_report: loss of control with values, interval and detected at", "[report]") {
  auto test = test::flow_test();
  auto& collapse = test.stored.summary.collapse;
  CHECK(holds(text_report({test}), "Onset of instability"));
  collapse.loss_of_control = triax::lab::Instant{340, 34.0, 0.006, 50e3, 80e3, 380e3};
  collapse.loss_of_control->interval = {{49e3, 51e3}, {78e3, 82e3}, {0.6, 0.65}};
  collapse.loss_of_control_detected_at = triax::lab::Moment{341, 34.1};
  std::string text = text_report({test});
  CHECK(holds(text, "Loss of control reading 340"));
  CHECK(holds(text, "with 95 %: η 0.600 to 0.650, q 49.0 to 51.0 kPa, p′ 78.0 to 82.0 kPa"));
  CHECK(holds(text, "detected at reading 341, 34.1 s; one reading later"));
  collapse.judged = false;  // it was seen all the same
  collapse.kind = triax::lab::CollapseKind::none;
  CHECK(holds(text_report({test}), "Loss of control reading 340"));
}

TEST_CASE("text_report: the total uncertainty with its largest source", "[report]") {
  auto test = test::flow_test();
  CHECK_FALSE(holds(text_report({test}), "total uncertainty"));
  test.stored.summary.collapse.onset->total = {
      .interval = {{55e3, 65e3}, {90e3, 110e3}, {0.5, 0.7}},
      .budget = {{"noise", 0.2}, {"gain of the load cell", 0.8}}};
  CHECK(holds(text_report({test}),
              "total uncertainty: η 0.500 to 0.700; largest source: gain of the load cell, 80 %"));
}

TEST_CASE("text_report: the true loss of control of a simulated test", "[report]") {
  auto test = test::simulated_test();
  CHECK_FALSE(holds(text_report({test}), "True loss of control"));
  test.stored.summary.truth->run_aways = {{.start_s = 40, .q_pa = 55e3, .p_eff_pa = 50e3}};
  CHECK(holds(text_report({test}), "True loss of control 40.0 s, q 55.0 kPa, p′ 50.0 kPa, η 1.10"));
}
