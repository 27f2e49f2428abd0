// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/response_envelope.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// The curves with points of the plot's left or right axes.
bool drawn_at(const QCustomPlot& plot, int side, double x, double y, double tolerance) {
  const auto* axis = const_cast<QCustomPlot&>(plot).axisRect(side)->axis(QCPAxis::atBottom);
  for (const auto* curve : test::curves_of(plot))
    if (curve->keyAxis() == axis && test::has_point(*curve, x, y, tolerance)) return true;
  return false;
}

}  // namespace

TEST_CASE("stress probes of 1 kPa lie on their circle, the strains beside it in 10^-6") {
  const auto circle = test::inl2_circle(0.6);
  const Drawing drawing = response_envelope(circle, 1e3, test::subject());
  REQUIRE(drawing.plot);
  REQUIRE(drawing.plot->axisRectCount() == 2);
  for (const auto& probe : circle.probes) {
    CHECK(drawn_at(*drawing.plot, 0, std::cos(probe.angle), std::sin(probe.angle), 1e-9));
    // The probes are rates of 1 Pa.
    CHECK(drawn_at(*drawing.plot, 1, probe.strain.x() * 1e9, probe.strain.y() * 1e9, 1e-6));
  }
  CHECK(test::contains(drawing.caption, "norm 1 kPa"));
  CHECK(test::contains(drawing.caption, "vermilion"));
  CHECK(test::contains(drawing.caption, "Simulated with inl2/S28-general"));
  for (const auto* curve : test::curves_in(*drawing.plot, kVermilion))
    CHECK(curve->dataCount() >= 3);
  CHECK(test::words_of(*drawing.plot).size() == 24);  // α every 30° on both sides
  CHECK(test::words_are_readable(*drawing.plot));
}

TEST_CASE("probes that had the norm are drawn as they are, those of another are scaled to it") {
  const auto circle = test::invented_circle([](double) { return 1.0; });
  CHECK(drawn_at(*response_envelope(circle, 1e3, test::subject()).plot, 1, 100, 0, 1e-9));
  CHECK(drawn_at(*response_envelope(circle, 2e3, test::subject()).plot, 1, 200, 0, 1e-9));
  CHECK(test::contains(response_envelope(circle, 1e3, test::subject()).caption,
                       "W₂ > 0 in all directions"));
}

TEST_CASE("strain probes have the envelope of stresses in kPa") {
  auto strain = test::subject();
  strain.kind = sim::ProbeKind::strain;
  const auto circle = test::inl2_circle(0.6, sim::ProbeKind::strain);
  const Drawing drawing = response_envelope(circle, 1e-5, strain);
  CHECK(drawn_at(*drawing.plot, 0, 10, 0, 1e-9));
  const auto& probe = circle.probes.front();
  CHECK(drawn_at(*drawing.plot, 1, probe.stress.x() * 1e-8, probe.stress.y() * 1e-8, 1e-9));
  CHECK(test::contains(drawing.caption, "10·10⁻⁶"));
}

TEST_CASE("both sides keep one scale on both axes; nothing is drawn of nothing") {
  const Drawing drawing = response_envelope(test::inl2_circle(0.6), 1e3, test::subject());
  for (int side = 0; side < 2; ++side) {
    const auto& rect = *drawing.plot->axisRect(side);
    const auto x = rect.axis(QCPAxis::atBottom)->range(), y = rect.axis(QCPAxis::atLeft)->range();
    CHECK(rect.width() / x.size() == Approx(rect.height() / y.size()).epsilon(0.02));
  }
  auto circle = test::invented_circle([](double) { return 1.0; });
  for (auto& probe : circle.probes) probe.answered = false;
  CHECK_FALSE(response_envelope(circle, 1e3, test::subject()).plot);
}
