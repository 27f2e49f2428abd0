// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/figures/grain_rose_figures.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;

namespace {

Subject subject_of_roses() { return {"sample", "probes"}; }

/// Spans of the areas of one colour, degrees.
std::vector<QCPRange> shaded(const QCustomPlot& plot, const QColor& colour) {
  std::vector<QCPRange> spans;
  for (const auto* curve : test::curves_of(plot)) {
    if (curve->brush().style() == Qt::NoBrush || curve->dataCount() == 0) continue;
    if (curve->brush().color().rgb() != colour.rgb()) continue;
    bool found = false;
    spans.push_back(curve->getKeyRange(found));
  }
  return spans;
}

}  // namespace

TEST_CASE("the envelope shows the strains as they are, without what did not come to rest") {
  const Drawing drawing = grain_envelope_figure(test::rose(), 1000, subject_of_roses());
  REQUIRE(drawing.plot);
  CHECK(test::any_has_point(*drawing.plot, 0, 10, 1e-9));  // α = 90°: dε₁ = 10·10⁻⁶
  CHECK(test::any_has_point(*drawing.plot, 0, 1, 1e-9));   // dσ₁ = 1 kPa
  const double a = sim::radians(140);
  CHECK_FALSE(test::any_has_point(*drawing.plot, 10 * std::cos(a), 10 * std::sin(a), 1e-6));
  CHECK(test::contains(drawing.caption,
                       "1 of 36 probes did not reach equilibrium. They are not used."));
  CHECK(test::contains(drawing.caption, "W₂ < 0 vermilion"));
}

TEST_CASE("Fig. 14: parts, micro and macro over the direction; ranges half a step wider") {
  const Drawing drawing = grain_work_figure(test::rose(), subject_of_roses());
  REQUIRE(drawing.plot);
  const QCustomPlot& plot = *drawing.plot;
  CHECK(plot.axisRectCount() == 2);
  CHECK(test::any_has_point(plot, 90, 0.01, 1e-12));     // (7)
  CHECK(test::any_has_point(plot, 90, 0.009, 1e-12));    // Δσ : LΔt
  CHECK(test::any_has_point(plot, 90, 0.0001, 1e-12));   // div(Δu) σ : LΔt
  CHECK(test::any_has_point(plot, 90, 0.0009, 1e-12));   // −σ Lᵗ Δt : LΔt
  CHECK(test::any_has_point(plot, 90, 0.012, 1e-12));    // (11)
  CHECK(test::any_has_point(plot, 360, 0.0101, 1e-12));  // closed
  CHECK_FALSE(test::any_has_point(plot, 140, 0.01, 1e-12));
  auto spans = shaded(plot, kVermilion);
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].lower == Approx(215));
  CHECK(spans[0].upper == Approx(235));
  spans = shaded(plot, kGreen);  // 230° through 0° to 60°
  REQUIRE(spans.size() == 2);
  CHECK(spans[0].lower == Approx(225));
  CHECK(spans[1].upper == Approx(65));
  CHECK(shaded(plot, kGrey).size() == 2);  // both panels
  CHECK(test::in_legend(plot, "micro = macro within 3 %"));
}

TEST_CASE("Fig. 15: shares in percent, energies on a logarithmic axis, the null probe named") {
  const Drawing drawing = grain_contacts_figure(test::rose(), subject_of_roses());
  REQUIRE(drawing.plot);
  CHECK(test::any_has_point(*drawing.plot, 90, 5, 1e-12));
  CHECK(test::any_has_point(*drawing.plot, 90, 0.1, 1e-12));
  CHECK(test::any_has_point(*drawing.plot, 90, 1e-6, 1e-18));
  CHECK(drawing.plot->axisRect(1)->axis(QCPAxis::atLeft)->scaleType() == QCPAxis::stLogarithmic);
  CHECK(test::in_legend(*drawing.plot, "null probe, 1.0e-12 J (below)"));
  const auto spans = shaded(*drawing.plot, kOrange);
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].lower == Approx(45));
  CHECK(spans[0].upper == Approx(265));
}

TEST_CASE("a piece of a rose is not closed, and where all agrees all is shaded once") {
  sim::ProbeRose rose = test::rose();
  rose.probes.resize(5);  // 0° to 40°
  CHECK_FALSE(
      test::any_has_point(*grain_work_figure(rose, subject_of_roses()).plot, 360, 0.01, 1e-9));
  rose = test::rose();
  for (auto& probe : rose.probes) probe = test::probe_at(sim::degrees(probe.angle), 0.01);
  const auto spans = shaded(*grain_work_figure(rose, subject_of_roses()).plot, kGreen);
  REQUIRE(spans.size() == 1);
  CHECK(spans[0].lower == 0);
  CHECK(spans[0].upper == 360);
}

TEST_CASE("without a probe there is no figure") {
  sim::ProbeRose rose = test::rose();
  for (auto& probe : rose.probes) probe.stopped = true;
  CHECK_FALSE(grain_envelope_figure(rose, 1000, subject_of_roses()).plot);
  CHECK_FALSE(grain_work_figure(rose, subject_of_roses()).plot);
  CHECK_FALSE(grain_contacts_figure({}, subject_of_roses()).plot);
}

TEST_CASE(
    "probes by strain: strains on the left, stresses answer; the explained gap lies on micro") {
  Subject by_strain = subject_of_roses();
  by_strain.kind = sim::ProbeKind::strain;
  const Drawing envelope = grain_envelope_figure(test::rose(), 2e-5, by_strain);
  REQUIRE(envelope.plot);
  CHECK(test::any_has_point(*envelope.plot, 0, 20, 1e-9));  // dε₁ = 20·10⁻⁶
  CHECK(test::any_has_point(*envelope.plot, 0, 1, 1e-9));   // dσ₁ = 1 kPa
  const Drawing work = grain_work_figure(test::rose(), by_strain);
  CHECK(test::contains(work.caption, "strain probe"));
  CHECK(test::any_has_point(*work.plot, 90, 0.01198, 1e-9));
}
