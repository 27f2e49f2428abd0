// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/set_figure.hpp"

#include <qcustomplot.h>

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_sheets.hpp"

using namespace triax;
using namespace triax::src;

namespace {

study::TestResult drained(study::TestResult test) {
  for (auto& stage : test.stored.header.stages) stage.drainage = lab::Drainage::open;
  test.stored.id = 9;
  double moved = 0;
  for (auto& s : test.curves.states) s.volumetric_strain = moved += 1e-5;
  return test;
}

}  // namespace

TEST_CASE("the plane of volumes of a set has no tests whose volume was shut in") {
  auto sheets = test::sheets_of({test::flow_test(), test::simulated_test()});
  const auto figure = [&] {
    std::vector<const SheetTest*> tests;
    for (const auto& test : sheets.tests) tests.push_back(&test);
    return set_figure(tests, axial_strain_axis(), volumetric_strain_axis());
  };
  CHECK(figure() == nullptr);
  sheets.tests.push_back(test::sheet_of(drained(test::flow_test())));
  const auto plot = figure();
  REQUIRE(plot != nullptr);
  int lines = 0;
  for (const auto* curve : test::curves_of(*plot)) lines += curve->dataCount() > 2 ? 1 : 0;
  CHECK(lines == 1);
}

TEST_CASE("a band begins and ends with its tests, whatever one of them did beyond") {
  std::vector<study::TestResult> many;
  for (int i = 0; i < 30; ++i) {
    many.push_back(test::flow_test());
    many.back().stored.id = i;
  }
  many.front().curves.states.back().strain.axial = 2;
  many.front().curves.states.back().q = 5e6;
  const auto sheets = test::sheets_of(std::move(many));
  std::vector<const SheetTest*> tests;
  for (const auto& test : sheets.tests) tests.push_back(&test);
  const auto plot = set_figure(tests, axial_strain_axis(), q_axis());
  REQUIRE(plot != nullptr);
  CHECK(plot->yAxis->range().upper < 100);
  CHECK(plot->xAxis->range().upper < 30);
}

TEST_CASE("those drawn of many keep no step with a sweep") {
  CHECK(drawn_of_many(24).size() == 24);
  for (const std::size_t values : {2, 3, 5, 8, 10}) {
    std::vector<int> seen(values, 0);
    const auto drawn = drawn_of_many(300);
    CHECK(drawn.size() <= 62);
    for (const auto i : drawn) ++seen[i % values];
    for (const int count : seen) CHECK(count >= 60 / static_cast<int>(values) / 3);
  }
}

TEST_CASE("consolidation of a set is drawn of the tests whose water was measured") {
  auto sheets = test::sheets_of({test::flow_test(), test::simulated_test(), test::flow_test()});
  std::vector<const SheetTest*> tests;
  for (auto& one : sheets.tests) {
    one.values.consolidation.reset();
    tests.push_back(&one);
  }
  CHECK(set_consolidation_figure(tests) == nullptr);
  for (auto& one : sheets.tests) {
    study::ConsolidationCurve curve;
    for (int i = 0; i < 5; ++i) curve.points.push_back({60.0 * i * i, 1e-6 * i});
    one.values.consolidation = curve;
  }
  sheets.tests[1].values.consolidation->in_m3 = false;  // strains, in other units
  const auto plot = set_consolidation_figure(tests);
  REQUIRE(plot != nullptr);
  CHECK(plot->yAxis->rangeReversed());
  int lines = 0;
  for (const auto* curve : test::curves_of(*plot)) {
    if (curve->dataCount() < 2) continue;
    ++lines;  // straight over the root of time: its ends are enough
    CHECK((curve->data()->constEnd() - 1)->key == Approx(4));
    CHECK((curve->data()->constEnd() - 1)->value == Approx(4));
  }
  CHECK(lines == 2);
}
