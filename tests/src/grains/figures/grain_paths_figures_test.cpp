// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/figures/grain_paths_figures.hpp"

#include <catch2/catch.hpp>

#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_grains.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

namespace {

Subject subject_of_paths() { return {"sample", "from p = 100 kPa"}; }

GrainCurve path(const std::string& label, double R) {
  GrainCurve drawn{label, test::rising_and_falling(R), 20, 22, {}};
  drawn.marks.push_back({"ES_a", drawn.points[10]});
  return drawn;
}

bool has_word(const QCustomPlot& plot, const std::string& word) {
  return std::ranges::any_of(test::words_of(plot),
                             [&](auto* w) { return w->text().toStdString() == word; });
}

}  // namespace

TEST_CASE("Fig. 16: q over p and the control stress over strain, with labels and named marks") {
  const Drawing drawing =
      grain_strain_paths_figure({path("R = 0.8", 0.8), path("R = 1", 1)}, subject_of_paths());
  REQUIRE(drawing.plot);
  const QCustomPlot& plot = *drawing.plot;
  CHECK(plot.axisRectCount() == 2);
  CHECK(test::any_has_point(plot, 0.2, 20, 1e-9));  // ε₁ in %, σ₁ − σ₃/R in kPa
  const auto peak = test::rising_and_falling(0.8)[20];
  CHECK(test::any_has_point(plot, peak.p_pa / 1e3, peak.q_pa / 1e3, 1e-9));
  CHECK(has_word(plot, "R = 0.8"));
  CHECK(has_word(plot, "ES_a"));
  CHECK(test::words_are_readable(*drawing.plot));
  CHECK(test::in_legend(plot, "R = 1"));
  CHECK(test::in_legend(plot, "W₂ < 0 from here"));
  CHECK(test::contains(drawing.caption, "on 2 of 2 paths"));
}

TEST_CASE("nothing is marked, nor in the legend, where nothing was found") {
  GrainCurve bare = path("R = 1", 1);
  bare.peak = bare.first_negative = std::nullopt;
  bare.marks.clear();
  const Drawing drawing = grain_strain_paths_figure({bare}, subject_of_paths());
  for (const char* word : {"peak", "W₂", "state"})
    CHECK_FALSE(test::in_legend(*drawing.plot, word));
  CHECK_FALSE(grain_strain_paths_figure({}, subject_of_paths()).plot);
  bare.points.clear();
  CHECK_FALSE(grain_strain_paths_figure({bare}, subject_of_paths()).plot);
}

TEST_CASE("shear shows q and the volumetric strain, compression p and porosity") {
  const auto at = test::rising_and_falling(0.8)[20];
  const Drawing shear = grain_shear_figure({path("shear", 0.8)}, subject_of_paths());
  CHECK(test::any_has_point(*shear.plot, 0.2, at.q_pa / 1e3, 1e-9));
  CHECK(test::any_has_point(*shear.plot, 0.2, 100 * at.volumetric_strain, 1e-9));
  const Drawing compression = grain_compression_figure({path("press", 0.8)}, subject_of_paths());
  CHECK(test::any_has_point(*compression.plot, 100 * at.volumetric_strain, at.p_pa / 1e3, 1e-9));
  CHECK(test::any_has_point(*compression.plot, 100 * at.volumetric_strain, 0.4, 1e-9));
  CHECK_FALSE(grain_shear_figure({}, subject_of_paths()).plot);
  CHECK_FALSE(grain_compression_figure({}, subject_of_paths()).plot);
}
