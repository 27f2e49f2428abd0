// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/domain/domain_figures.hpp"

#include <catch2/catch.hpp>

#include "src/study/domain/domain_cones.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/sample_domain.hpp"

using namespace triax;
using namespace triax::src;
using namespace triax::study;

TEST_CASE("cones of a domain: its limit and its instability lines are those of its columns") {
  const ReportedDomain domain = sample_domain();
  const auto figures = domain_cones(domain, cones_picture(domain, {}));
  REQUIRE(figures.size() == 2);
  CHECK(figures[0].name == "cones_pq");
  const QCustomPlot& plot = *figures[0].drawing.plot;
  CHECK(test::in_legend(plot, "instability line (isotropic unloading)"));
  CHECK(test::in_legend(plot, "plastic limit"));
  CHECK_FALSE(test::in_legend(plot, "M ="));
  for (const auto& column : domain.columns) {
    REQUIRE(column.compression.isotropic_unloading);
    CHECK(test::any_has_point(plot, column.p_eff_kPa, column.compression.isotropic_unloading->q_kPa,
                              1e-9));
  }
}

TEST_CASE("the map names material and void ratio in the picture") {
  const auto svg = to_svg(*domain_map(sample_domain()).plot);
  CHECK(test::contains(svg, ">simulated: inl2/S28-general, e = 1.086<"));
}
