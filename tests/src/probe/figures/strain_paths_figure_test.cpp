// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/probe/figures/strain_paths_figure.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// σ₁′ − σ₃′/R rises to 40 R kPa at ε₁ = 1 % and falls to `end` at 4 %.
sim::StrainPath path(double R, double end_kPa) {
  sim::StrainPath p;
  p.R = R;
  const auto point = [](double strain, double stress, double mean, double q) {
    return sim::StrainPathPoint{strain, stress * 1e3, mean * 1e3, q * 1e3, 1, 0};
  };
  p.points = {point(0, 0, 100, 0), point(0.01, 40 * R, 75, 40 * R),
              point(0.04, end_kPa, 20 + end_kPa, end_kPa)};
  p.peak = p.first_unstable = p.points[1];
  return p;
}

bool has_word(const QCustomPlot& plot, const std::string& word) {
  const auto words = test::words_of(plot);
  return std::ranges::any_of(words, [&](auto* w) { return w->text().toStdString() == word; });
}

}  // namespace

TEST_CASE("both sides hold all paths, in percent and kPa, with R beside the peaks") {
  const Drawing drawing = strain_paths_figure({path(0.7, 2), path(1, 30)}, test::subject());
  REQUIRE(drawing.plot);
  CHECK(drawing.plot->axisRectCount() == 2);
  CHECK(test::any_has_point(*drawing.plot, 1, 28, 1e-9));  // ε₁ in %, σ₁′ − σ₃′/R in kPa
  CHECK(test::any_has_point(*drawing.plot, 75, 40, 1e-9));  // q over p′
  CHECK(has_word(*drawing.plot, "R = 0.7"));
  CHECK(has_word(*drawing.plot, "R = 1"));
  CHECK(test::words_are_readable(*drawing.plot));
  CHECK(test::contains(drawing.caption, "2 of 2 have a peak"));
}

TEST_CASE("R stands beside the curves in the order of the peaks, apart, though all ends meet") {
  std::vector<sim::StrainPath> paths;
  for (const double R : {0.7, 0.8, 0.825, 0.85, 0.875, 0.9, 1.0}) paths.push_back(path(R, 0));
  const Drawing drawing = strain_paths_figure(paths, test::subject());
  CHECK(test::words_are_readable(*drawing.plot));
  const auto words = test::words_of(*drawing.plot);
  REQUIRE(words.size() == paths.size());
  const auto place = [&](const std::string& name) {
    const auto found =
        std::ranges::find_if(words, [&](auto* w) { return w->text().toStdString() == name; });
    REQUIRE(found != words.end());
    return test::place_of(**found);
  };
  for (std::size_t i = 0; i + 1 < paths.size(); ++i)
    CHECK(place(fmt::format("R = {:g}", paths[i].R)).top() >
          place(fmt::format("R = {:g}", paths[i + 1].R)).top());
  // No curve runs through the words.
  const auto& right = *drawing.plot->axisRect(1);
  for (const auto* word : words)
    for (int k = 0; k <= 100; ++k) {
      const double strain = 1 + 0.03 * k, stress = 40 * (1 - 0.01 * k);
      CHECK_FALSE(test::place_of(*word).contains(
          QPointF(right.axis(QCPAxis::atBottom)->coordToPixel(strain),
                  right.axis(QCPAxis::atLeft)->coordToPixel(stress))));
    }
  CHECK(test::in_legend(*drawing.plot, "R = 0.7"));
  CHECK(test::in_legend(*drawing.plot, "W₂ = 0"));
}

TEST_CASE("peak and W2 = 0 are marked where they are, and not where there are none") {
  auto without = path(1, 30);
  without.peak = without.first_unstable = std::nullopt;
  const auto marks = [](const Drawing& drawing) {
    std::size_t count = 0;
    for (const auto* curve : test::curves_of(*drawing.plot))
      if (curve->lineStyle() == QCPCurve::lsNone && curve->dataCount() > 0) ++count;
    return count;
  };
  CHECK(marks(strain_paths_figure({without}, test::subject())) == 0);
  CHECK(marks(strain_paths_figure({path(1, 30)}, test::subject())) == 4);
  CHECK_FALSE(strain_paths_figure({}, test::subject()).plot);
  CHECK_FALSE(strain_paths_figure({{}}, test::subject()).plot);
}
