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
  CHECK(holds(text_report({test}), "Detected not before the record ended"));
  auto& collapse = test.stored.summary.collapse;
  collapse.onset->interval = {{58e3, 61e3}, {96e3, 104e3}, {0.57, 0.62}};
  collapse.onset_detected_at = triax::lab::Moment{330, 33.0};
  collapse.criteria[0].detected_at = triax::lab::Moment{340, std::nullopt};
  test.stored.events = {{301, 30.1, triax::lab::EventKind::loss_of_sustainability, "q fell away",
                         triax::lab::Moment{335, 33.5}}};
  const std::string text = text_report({test});
  CHECK(holds(text, "loss of sustainability 301 30.1 s 335 33.5 s q fell away"));
  CHECK(holds(text, "with 95 %: η 0.570 to 0.620, q 58.0 to 61.0 kPa, p′ 96.0 to 104.0 kPa"));
  CHECK(holds(text, "Detected at reading 330, 33.0 s; 30 readings after the onset"));
  CHECK(holds(text, "340"));
}
