#include "src/figures/control_scan_figure.hpp"

#include <catch2/catch.hpp>

#include "tests/src/figures/plot_contents.hpp"
#include "tests/src/figures/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// Index (R − a)(R − b).
NamedScan scan(const std::string& name, double a, double b) {
  NamedScan s{name, {}, {a, b}};
  for (int i = 1; i <= 20; ++i) {
    const double R = 0.1 * i;
    s.scan.push_back({R, false, (R - a) * (R - b), {}});
  }
  return s;
}

}  // namespace

TEST_CASE("a curve a state, the roots on the line 0 with their values") {
  const Drawing drawing = control_scan_figure(
      {scan("η = 0.55", 0.2537, 1.3407), scan("η = 0.60", 0.4, 1)}, test::subject());
  REQUIRE(drawing.plot);
  CHECK(test::any_has_point(*drawing.plot, 0.1, (0.1 - 0.2537) * (0.1 - 1.3407), 1e-9));
  CHECK(test::any_has_point(*drawing.plot, 1.3407, 0, 1e-9));
  CHECK(test::in_legend(*drawing.plot, "η = 0.60"));
  CHECK(test::in_legend(*drawing.plot, "Eq. (34)"));
  CHECK(test::contains(drawing.caption, "η = 0.55: R = 0.2537 and 1.341"));
  CHECK(test::words_of(*drawing.plot).size() == 4);
  CHECK(test::words_are_readable(*drawing.plot));
}

TEST_CASE("without loss of control there is nothing to shade and no root") {
  NamedScan stable{"", {{0.5, true, 0.4, {}}, {1, true, 0.3, {}}}, {}};
  const Drawing drawing = control_scan_figure({stable}, test::subject());
  CHECK(drawing.plot->yAxis->range().lower <= 0);
  CHECK_FALSE(test::in_legend(*drawing.plot, "roots"));
  CHECK_FALSE(test::contains(drawing.caption, "roots"));
  CHECK_FALSE(control_scan_figure({}, test::subject()).plot);
}

TEST_CASE("plane strain has Eq. (35) and one R") {
  auto plane = test::subject();
  plane.plane = sim::ProbePlane::plane_strain;
  const Drawing drawing = control_scan_figure({scan("", 0.5, 1)}, plane);
  CHECK(test::in_legend(*drawing.plot, "Eq. (35)"));
  CHECK(test::contains(drawing.caption, "dε₁ + R dε₃"));
}
