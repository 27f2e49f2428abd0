// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of one test and of all collapse points: that what is drawn is where the data are, and
// nothing without data.
#include <qcustomplot.h>

#include <catch2/catch.hpp>
#include <clocale>
#include <cstdlib>

#include "src/triaxial/figures/collapse_points_figure.hpp"
#include "src/triaxial/figures/history_figure.hpp"
#include "src/triaxial/figures/stress_path_figure.hpp"
#include "src/triaxial/figures/warning_figure.hpp"
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
  const Drawing drawing = stress_path_figure(stress_path(test::flow_test()));
  REQUIRE(drawing.plot);
  CHECK(drawn_at(*drawing.plot, 140, 0, 0.5));
  CHECK(drawn_at(*drawing.plot, 100, 60, 0.5));
  CHECK(drawing.plot->xAxis->range().contains(100));
  CHECK(drawing.plot->yAxis->range().contains(60));
  CHECK(drawing.caption.find("0.60") != std::string::npos);
}

TEST_CASE("all collapse points lie where the tests say, with the line that fits them") {
  const Drawing drawing = collapse_points_figure(
      collapse_points({test::flow_test(), test::simulated_test(), test::stable_test()}));
  REQUIRE(drawing.plot);
  CHECK(drawn_at(*drawing.plot, 100, 60, 0.01));
  CHECK(drawn_at(*drawing.plot, 200, 110, 0.01));
  CHECK(drawing.caption.find("2 tests") != std::string::npos);
  CHECK(drawing.caption.find("η = 0.56") != std::string::npos);
  CHECK_FALSE(collapse_points_figure({}).plot);
}

TEST_CASE("histories have four panels on one axis; a path without points is not drawn") {
  const Drawing history = history_figure(*study::history(test::flow_test(), Span::shear));
  REQUIRE(history.plot);
  CHECK(history.plot->axisRectCount() == 4);
  const auto range = history.plot->axisRect(0)->axis(QCPAxis::atBottom)->range();
  for (int i = 1; i < 4; ++i)
    CHECK(history.plot->axisRect(i)->axis(QCPAxis::atBottom)->range() == range);
  CHECK_FALSE(stress_path_figure({}).plot);
}

TEST_CASE("without time histories go along the readings, and the axis says so") {
  auto test = test::stable_test();
  for (auto& state : test.curves.states)  // to ε₁ = 7.5 % and back
    if (state.reading > 250) state.strain.axial = 3e-4 * static_cast<double>(500 - state.reading);
  const Drawing history = history_figure(*study::history(test, Span::shear));
  REQUIRE(history.plot);
  CHECK(history.plot->axisRectCount() == 4);
  const auto* bottom = history.plot->axisRect(3)->axis(QCPAxis::atBottom);
  CHECK(bottom->label() == "reading (no time in the record)");
  CHECK(bottom->range() == QCPRange(0, 500));
  CHECK(drawn_at(*history.plot, 250, 7.5, 1e-6));  // ε₁ in %, where it was unloaded
  CHECK(drawn_at(*history.plot, 500, 0, 1e-6));
  CHECK_THAT(history.caption, Catch::Contains("along its readings"));
}

TEST_CASE(
    "what the alarm forecast is drawn with its band, cut at the axes, below the marks' names") {
  auto told = test::flow_test();
  for (int i = 60; i <= 290; i += 2)
    told.curves.forecasts.push_back({i, 0.1 * i, 0.61, 0.61 - 10.0 / i, 0.61 + 1000.0 / i, {}});
  told.stored.events = {{250, 25, lab::EventKind::imminent, "soon", lab::Moment{250, 25.0}}};
  const Drawing drawing = warning_figure(*warning_history(told));
  REQUIRE(drawing.plot);
  CHECK(drawing.plot->axisRectCount() == 2);
  CHECK(drawn_at(*drawing.plot, 20, 0.61, 1e-9));
  CHECK(drawn_at(*drawing.plot, 20, 0.56, 1e-9));  // 0.61 - 10/200
  CHECK(drawn_at(*drawing.plot, 30, 0.6, 1e-3));   // measured
  CHECK(drawn_at(*drawing.plot, 30, 60, 0.1));
  const auto range = drawing.plot->axisRect(0)->axis(QCPAxis::atLeft)->range();
  CHECK(range.upper < 2);
  CHECK(drawn_at(*drawing.plot, 20, range.upper, 1e-9));
  CHECK(to_svg(*drawing.plot).find("imminent") != std::string::npos);
}

TEST_CASE("figures need no screen") {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  const Drawing drawing = stress_path_figure(stress_path(test::flow_test()));
  const std::string png = to_png(*drawing.plot, 1);
  CHECK(png.rfind("\x89PNG", 0) == 0);
  CHECK(png.size() > 5000);
  CHECK(to_svg(*drawing.plot).find("<svg") != std::string::npos);
}

TEST_CASE("numbers in figures read the same in every locale, and no character breaks their XML") {
  auto odd = test::flow_test();
  odd.stored.header.name = "esc \x1b[31m \x01 end";
  const auto drawn = [&] {
    const Drawing drawing = collapse_points_figure(collapse_points({odd, test::simulated_test()}));
    return to_svg(*drawing.plot);
  };
  const std::string svg = drawn();
  CHECK(svg.find("esc") != std::string::npos);
  for (const char c : svg) CHECK((c < 0 || c >= ' ' || c == '\n' || c == '\t' || c == '\r'));
  need_drawing();
  CHECK(QLocale().decimalPoint() == ".");
  CHECK(QLocale().name() == "C");
  const QCustomPlot plot;
  CHECK(plot.locale().toString(-0.5) == "-0.5");
  CHECK(std::string(std::localeconv()->decimal_point) == ".");
}
