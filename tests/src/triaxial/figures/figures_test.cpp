// The three figures: that what is drawn is where the data are, and nothing without data.
#include <qcustomplot.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "src/study/triaxial/curves.hpp"
#include "src/triaxial/figures/collapse_points_figure.hpp"
#include "src/triaxial/figures/history_figure.hpp"
#include "src/triaxial/figures/stress_path_figure.hpp"
#include "src/triaxial/figures/test_figures.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {

/// True if any curve or graph of the plot has a point there, within a pixel or so.
bool drawn_at(QCustomPlot& plot, double key, double value, double tolerance) {
  for (int i = 0; i < plot.plottableCount(); ++i) {
    if (const auto* curve = qobject_cast<QCPCurve*>(plot.plottable(i)))
      for (const auto& point : *curve->data())
        if (std::fabs(point.key - key) < tolerance && std::fabs(point.value - value) < tolerance)
          return true;
    if (const auto* graph = qobject_cast<QCPGraph*>(plot.plottable(i)))
      for (const auto& point : *graph->data())
        if (std::fabs(point.key - key) < tolerance && std::fabs(point.value - value) < tolerance)
          return true;
  }
  return false;
}

}  // namespace

TEST_CASE("the stress path passes its start and its onset, and both are inside the axes") {
  const Drawing drawing = stress_path_figure(test::flow_test());
  REQUIRE(drawing.plot);
  CHECK(drawn_at(*drawing.plot, 140, 0, 0.5));
  CHECK(drawn_at(*drawing.plot, 100, 60, 0.5));
  CHECK(drawing.plot->xAxis->range().contains(100));
  CHECK(drawing.plot->yAxis->range().contains(60));
  CHECK(drawing.caption.find("0.60") != std::string::npos);
}

TEST_CASE("all collapse points lie where the tests say, and one line fits them") {
  const std::vector<TestResult> tests = {test::flow_test(), test::simulated_test(),
                                         test::stable_test()};
  const Drawing drawing = collapse_points_figure(tests);
  REQUIRE(drawing.plot);
  CHECK(drawn_at(*drawing.plot, 100, 60, 0.01));
  CHECK(drawn_at(*drawing.plot, 200, 110, 0.01));
  CHECK(*fitted_instability_line(tests) ==
        Approx((60.0 * 100 + 110 * 200) / (100 * 100 + 200 * 200.0)));
}

TEST_CASE("a failure on the limit surface is no collapse point") {
  auto surface = test::flow_test();
  surface.stored.summary.collapse.kind = lab::CollapseKind::none;
  surface.stored.summary.collapse.inside_limit_surface = false;
  CHECK_FALSE(fitted_instability_line({surface}));
  CHECK_FALSE(collapse_points_figure({surface}).plot);
}

TEST_CASE("histories have four panels on one axis; without data nothing is drawn") {
  const Drawing history = history_figure(test::flow_test(), Span::shear);
  REQUIRE(history.plot);
  CHECK(history.plot->axisRectCount() == 4);
  const auto range = history.plot->axisRect(0)->axis(QCPAxis::atBottom)->range();
  for (int i = 1; i < 4; ++i)
    CHECK(history.plot->axisRect(i)->axis(QCPAxis::atBottom)->range() == range);
  TestResult nothing = test::stable_test();
  nothing.curves = {};
  CHECK_FALSE(history_figure(nothing, Span::shear).plot);
  CHECK_FALSE(stress_path_figure(nothing).plot);
  CHECK(test_figures(nothing).empty());
}

TEST_CASE("figures need no screen") {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  const Drawing drawing = stress_path_figure(test::flow_test());
  const std::string png = to_png(*drawing.plot, 1);
  CHECK(png.rfind("\x89PNG", 0) == 0);
  CHECK(png.size() > 5000);
  CHECK(to_svg(*drawing.plot).find("<svg") != std::string::npos);
}

TEST_CASE("thinning keeps few states, and never loses the peak") {
  auto test = test::flow_test();
  CurveThinner thinner(901, 20);
  for (const auto& state : test.curves.states) thinner.add(state);
  const auto kept = thinner.take();
  CHECK(kept.size() <= 20 * 20);
  double q = 0;
  for (const auto& state : kept) q = std::max(q, state.q);
  CHECK(q == Approx(60e3).epsilon(1e-4));
  CHECK(kept.front().reading == 0);
  CHECK(kept.back().reading == 900);
}

TEST_CASE("thinning leaves a steep smooth fall a curve, not the straight line of its two ends") {
  constexpr std::int64_t kScans = 40000;  // 400 in a bucket; q falls within 300 of them
  CurveThinner thinner(kScans, 100);
  for (std::int64_t i = 0; i < kScans; ++i) {
    lab::State state;
    state.reading = i;
    const double fallen = std::clamp(static_cast<double>(i - 20050) / 300, 0.0, 1.0);
    state.q = 100e3 * (1 - fallen * fallen);
    thinner.add(state);
  }
  int within = 0;
  for (const auto& state : thinner.take()) within += state.q > 1e3 && state.q < 99e3 ? 1 : 0;
  CHECK(within >= 5);
}
