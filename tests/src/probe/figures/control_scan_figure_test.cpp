// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/control_scan_figure.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// Index (R − a)(R − b), lost between a and b.
NamedScan scan(const std::string& name, double a, double b) {
  NamedScan s{name, {}, {{a, b, true, true}}};
  for (int i = 1; i <= 20; ++i) {
    const double R = 0.1 * i;
    s.scan.push_back({R, R < a || R > b, (R - a) * (R - b), {}, {}});
  }
  return s;
}

/// The curve of a state, which holds its first point.
const QCPCurve& curve_through(const QCustomPlot& plot, double R, double index) {
  for (const auto* curve : test::curves_of(plot))
    if (test::has_point(*curve, R, index, 1e-9)) return *curve;
  throw std::logic_error("no curve");
}

std::vector<QRectF> bands(const QCustomPlot& plot) {
  std::vector<QRectF> bands;
  for (const auto* curve : test::curves_of(plot)) {
    if (curve->brush().style() == Qt::NoBrush || curve->dataCount() == 0) continue;
    const auto a = *curve->data()->at(0), b = *curve->data()->at(2);
    bands.push_back(QRectF(QPointF(a.key, a.value), QPointF(b.key, b.value)).normalized());
  }
  return bands;
}

}  // namespace

TEST_CASE("a curve a state runs to 0 at its limits of control, and has a gap between them") {
  const Drawing drawing = control_scan_figure(
      {scan("η = 0.55", 0.2537, 1.3407), scan("η = 0.60", 0.4, 1)}, test::subject());
  REQUIRE(drawing.plot);
  const auto& curve = curve_through(*drawing.plot, 0.1, (0.1 - 0.2537) * (0.1 - 1.3407));
  CHECK(test::has_point(curve, 0.2537, 0, 1e-12));
  CHECK(test::has_point(curve, 1.3407, 0, 1e-12));
  int gaps = 0;
  for (const auto& point : *curve.data()) {
    if (std::isnan(point.value)) ++gaps;
    CHECK_FALSE((point.key > 0.26 && point.key < 1.34 && std::isfinite(point.value)));
    CHECK_FALSE(point.value < 0);
  }
  CHECK(gaps == 1);
  CHECK(test::in_legend(*drawing.plot, "η = 0.60"));
  CHECK(test::in_legend(*drawing.plot, "limit of control"));
  CHECK_FALSE(test::in_legend(*drawing.plot, "Eq. (34)"));
  CHECK(test::contains(drawing.caption, "η = 0.55: R = 0.2537 and 1.341"));
  CHECK(test::words_of(*drawing.plot).size() == 4);
  CHECK(test::words_are_readable(*drawing.plot));
}

TEST_CASE("bands over the height of the axes are the ranges of R in which control is lost") {
  auto open = scan("", 0.5, 5);  // control is not found again on the axis
  open.lost[0].ends = false;
  const Drawing drawing = control_scan_figure({scan("", 0.3, 1.2), open}, test::subject());
  const auto shaded = bands(*drawing.plot);
  REQUIRE(shaded.size() == 2);
  CHECK(shaded[0].left() == Approx(0.3));
  CHECK(shaded[0].right() == Approx(1.2));
  CHECK(shaded[0].bottom() == Approx(drawing.plot->yAxis->range().upper));
  CHECK(shaded[0].top() == Approx(drawing.plot->yAxis->range().lower));
  CHECK(shaded[1].left() == Approx(0.5));
  CHECK(shaded[1].right() == Approx(drawing.plot->xAxis->range().upper));
  CHECK(open.limits() == std::vector<double>{0.5});
  CHECK(test::words_of(*drawing.plot).size() == 3);
}

TEST_CASE("without loss of control there is nothing to shade and no limit") {
  NamedScan stable{"", {{0.5, true, 0.4, {}, {}}, {1, true, 0.3, {}, {}}}, {}};
  const Drawing drawing = control_scan_figure({stable}, test::subject());
  CHECK(drawing.plot->yAxis->range().lower <= 0);
  CHECK_FALSE(test::in_legend(*drawing.plot, "limit"));
  CHECK_FALSE(test::in_legend(*drawing.plot, "lost"));
  CHECK(bands(*drawing.plot).empty());
  CHECK_FALSE(test::contains(drawing.caption, "limits"));
  CHECK_FALSE(control_scan_figure({}, test::subject()).plot);
}

TEST_CASE("plane strain has one R") {
  auto plane = test::subject();
  plane.plane = sim::ProbePlane::plane_strain;
  const Drawing drawing = control_scan_figure({scan("", 0.5, 1)}, plane);
  CHECK(test::contains(drawing.caption, "dε₁ + R dε₃"));
}
