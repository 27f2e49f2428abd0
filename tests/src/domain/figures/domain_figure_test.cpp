// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/domain/figures/domain_figure.hpp"

#include <catch2/catch.hpp>

#include "src/plot/plot_style.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;
using enum sim::DomainStateKind;

namespace {

constexpr int kRows = 6;

/// p′ = 100, 200 kPa; q = 0 to 250 kPa by 50: two stable rows, two unstable, two beyond the limit.
sim::DomainGrid grid() {
  sim::DomainGrid g;
  g.p_from = 100e3;
  g.p_to = 200e3;
  g.columns = 2;
  g.q_to = 250e3;
  g.rows = kRows;
  return g;
}

std::vector<sim::DomainColumn> columns() {
  std::vector<sim::DomainColumn> all;
  for (int c = 0; c < 2; ++c) {
    sim::DomainColumn column;
    column.column = c;
    column.p = 100e3 * (c + 1);
    for (int r = 0; r < kRows; ++r) {
      sim::DomainState state{50e3 * r,
                             r < 2   ? stable
                             : r < 4 ? unstable
                                     : beyond_limit,
                             {},
                             {},
                             {}};
      if (state.kind == unstable) {
        state.least_work = -0.1 * r;
        state.cones = {{3.7, 3.7 + 0.1 * r}, {5, 5.1}};
      }
      column.states.push_back(state);
    }
    column.compression.first_unstable_q = 75e3 + 1e3 * c;
    column.compression.first_unstable_angle = sim::kIsotropicUnloading;
    column.compression.limit_q = 180e3;
    all.push_back(column);
  }
  return all;
}

QCPColorMap& map_of(const QCustomPlot& plot) {
  for (int i = 0; i < plot.plottableCount(); ++i)
    if (auto* map = qobject_cast<QCPColorMap*>(const_cast<QCustomPlot&>(plot).plottable(i)))
      return *map;
  throw std::logic_error("no map");
}

Subject subject() { return {"inl2/S28-general", "e = 1.086"}; }

}  // namespace

TEST_CASE("the value of a state is the sum of its cones in degrees") {
  const auto all = columns();
  const auto& states = all[0].states;
  CHECK_FALSE(domain_value(states[1]));
  CHECK(*domain_value(states[3]) == Approx(sim::degrees(0.4)));
  CHECK_FALSE(domain_value(states[5]));
}

TEST_CASE("unstable states are coloured, stable ones left white, those beyond the limit grey") {
  const Drawing drawing = domain_figure(grid(), columns(), subject());
  REQUIRE(drawing.plot);
  auto& data = *map_of(*drawing.plot).data();
  CHECK(data.alpha(0, 1) == 0);
  CHECK(data.alpha(0, 2) == 255);
  CHECK(data.cell(1, 3) == Approx(sim::degrees(0.4)));
  CHECK(data.alpha(1, 5) == 255);
  CHECK(std::isnan(data.cell(1, 5)));
  CHECK(data.keyRange() == QCPRange(100, 200));
  CHECK(data.valueRange() == QCPRange(0, 250));
  CHECK(test::contains(drawing.caption, "4 of 12 states"));
}

TEST_CASE("states of which not all directions are answered look neither stable nor refused") {
  auto all = columns();
  const Drawing without = domain_figure(grid(), all, subject());
  CHECK_FALSE(test::in_legend(*without.plot, "no result in some directions"));
  all[0].states[1].kind = unknown;
  all[0].states[1].least_work = 0.3;
  const Drawing drawing = domain_figure(grid(), all, subject());
  CHECK(test::in_legend(*drawing.plot, "no result in some directions"));
  std::vector<QCPColorMap*> maps;
  for (int i = 0; i < drawing.plot->plottableCount(); ++i)
    if (auto* map = qobject_cast<QCPColorMap*>(drawing.plot->plottable(i))) maps.push_back(map);
  REQUIRE(maps.size() == 2);
  CHECK(maps[0]->data()->alpha(0, 1) == 0);
  CHECK(maps[1]->data()->alpha(0, 1) == 255);
  CHECK(maps[1]->data()->alpha(0, 0) == 0);
  CHECK(maps[1]->data()->alpha(1, 1) == 0);
}

TEST_CASE("columns of a piece are put in their places; the rest stays white") {
  auto piece = columns();
  piece.erase(piece.begin());
  const Drawing drawing = domain_figure(grid(), piece, subject());
  auto& data = *map_of(*drawing.plot).data();
  CHECK(data.alpha(0, 3) == 0);
  CHECK(data.cell(1, 3) == Approx(sim::degrees(0.4)));
  CHECK(test::contains(drawing.caption, "2 of 6 states"));
  CHECK_FALSE(domain_figure(grid(), {}, subject()).plot);
}

TEST_CASE("boundaries run through their q in kPa; only what is known is drawn and named") {
  const Drawing drawing = domain_figure(grid(), columns(), subject());
  CHECK(test::any_has_point(*drawing.plot, 100, 75, 1e-9));
  CHECK(test::any_has_point(*drawing.plot, 200, 76, 1e-9));
  CHECK(test::any_has_point(*drawing.plot, 200, 180, 1e-9));
  CHECK(test::in_legend(*drawing.plot, "first unstable"));
  CHECK(test::in_legend(*drawing.plot, "plastic limit"));
  CHECK_FALSE(test::in_legend(*drawing.plot, "determinant"));
  CHECK_FALSE(test::in_legend(*drawing.plot, "localisation"));
}

TEST_CASE("arrows start on the boundary and point along the first unstable direction") {
  const Drawing drawing = domain_figure(grid(), columns(), subject());
  int arrows = 0;
  for (int i = 0; i < drawing.plot->itemCount(); ++i)
    if (const auto* arrow = qobject_cast<QCPItemLine*>(drawing.plot->item(i))) {
      ++arrows;
      CHECK(arrow->end->coords().y() == Approx(arrow->start->coords().y()));  // dq = 0
      CHECK(arrow->end->coords().x() < arrow->start->coords().x());
    }
  CHECK(arrows == 2);
  auto plane_strain = subject();
  plane_strain.plane = sim::ProbePlane::plane_strain;
  const Drawing other = domain_figure(grid(), columns(), plane_strain);
  CHECK_FALSE(test::contains(other.caption, "arrows"));
  CHECK(test::contains(other.caption, "plane strain"));
}

TEST_CASE("the scale ends at round values beyond the largest, and its steps at their ends") {
  const Drawing opening = domain_figure(grid(), columns(), subject());
  CHECK(map_of(*opening.plot).dataRange() == QCPRange(0, 25));  // 22.9°
}

TEST_CASE("the determinant is dots on the line of the first unstable direction, so both are seen") {
  auto all = columns();
  for (auto& column : all)
    if (const auto q = column.compression.first_unstable_q)
      column.compression.others_q["determinant"] = *q;
  const Drawing drawing = domain_figure(grid(), all, subject());
  CHECK(test::in_legend(*drawing.plot, "vanishing determinant"));
  int dots = 0;
  for (const auto* curve : test::curves_of(*drawing.plot))
    if (curve->lineStyle() == QCPCurve::lsNone && curve->scatterStyle().pen().color() == kPurple)
      for (const auto& point : *curve->data()) {
        ++dots;
        CHECK((point.value == 75 || point.value == 76));
      }
  CHECK(dots == 2);
  CHECK(test::curves_in(*drawing.plot, kPurple).empty());
  CHECK(test::curves_in(*drawing.plot, kBlue).size() == 1);
}
