// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/subject.hpp"

#include <catch2/catch.hpp>

#include "sim/mechanics/axisymmetric.hpp"
#include "src/domain/figures/domain_figure.hpp"
#include "src/probe/figures/circular_diagram.hpp"
#include "src/probe/figures/cones_figure.hpp"
#include "src/probe/figures/control_scan_figure.hpp"
#include "src/probe/figures/response_envelope.hpp"
#include "src/probe/figures/sphere_figure.hpp"
#include "src/probe/figures/strain_paths_figure.hpp"
#include "src/probe/figures/work_over_angle.hpp"
#include "tests/src/plot/plot_contents.hpp"
#include "tests/src/probe/sample_circles.hpp"

using namespace triax;
using namespace triax::src;
using enum sim::ProbePlane;

TEST_CASE("axes of the two planes, and isotropic unloading in them") {
  CHECK(stress_x_name(axisymmetric) == "√2 dσ₃");
  CHECK(stress_x_name(plane_strain) == "dσ₃");
  CHECK(strain_x_name(axisymmetric) == "√2 dε₃");
  CHECK(sim::degrees(isotropic_unloading(axisymmetric)) == Approx(215.264).margin(1e-3));
  CHECK(sim::degrees(isotropic_unloading(plane_strain)) == Approx(225));
}

TEST_CASE("a caption says that it is simulated, with what and where") {
  CHECK(simulated_with({"inl2/S28-general", "e = 1.086"}) ==
        "Simulated with inl2/S28-general, e = 1.086.");
  CHECK(simulated_with({"my/law", "", plane_strain}) == "Simulated with my/law, plane strain.");
}

namespace {

std::vector<Drawing> every_kind() {
  const Subject subject = test::subject();
  const auto circle = test::inl2_circle(0.6);
  const std::vector<NamedCircle> circles = {{"η = 0.60", circle}};
  sim::DomainGrid grid;
  grid.p_from = 100e3;
  grid.p_to = 200e3;
  grid.columns = 1;
  grid.q_to = 100e3;
  grid.rows = 2;
  sim::DomainColumn column;
  column.p = 100e3;
  sim::StrainPath path;
  path.points = {{0, 0, 100e3, 0, 1, 0}, {0.01, 40e3, 75e3, 40e3, 1, 0}};
  std::vector<Drawing> all;
  all.push_back(circular_diagram(circles, subject));
  all.push_back(polar_diagram(circles, subject));
  all.push_back(work_over_angle(circles, subject));
  all.push_back(response_envelope(circle, 1e3, subject));
  all.push_back(control_scan_figure({{"", {{1, true, 0.4, {}, {}}}, {}}}, subject));
  all.push_back(cones_figure({.states = {{{70e3, 42e3}, study::sectors_of(circle)}}}, subject,
                             StressAxes::p_q));
  all.push_back(sphere_figure({{{1, 0, 0}, {1, 0, 0}, true, 1}}, subject));
  all.push_back(domain_figure(grid, {column}, subject));
  all.push_back(strain_paths_figure({path}, subject));
  return all;
}

/// The line of origin in the layout of a plot.
const QCPTextElement& origin_in(const QCustomPlot& plot) {
  for (auto* element : plot.plotLayout()->elements(true))
    if (const auto* text = qobject_cast<QCPTextElement*>(element)) return *text;
  throw std::logic_error("no line of origin");
}

}  // namespace

TEST_CASE("every figure says in itself what it is simulated with, below all else") {
  const auto drawings = every_kind();
  for (const auto& drawing : drawings) {
    REQUIRE(drawing.plot);
    CHECK(test::contains(to_svg(*drawing.plot),
                         ">simulated: inl2/S28-general, p′ = 70 kPa, e = 1.086<"));
    const QRect line = origin_in(*drawing.plot).outerRect();
    CHECK(drawing.plot->rect().contains(line));
    CHECK(line.top() >= drawing.plot->legend->outerRect().bottom());
    CHECK(line.top() >= drawing.plot->axisRect()->outerRect().bottom());
  }
}

TEST_CASE("an origin wider than its plot stands in several lines, none cut off") {
  const std::string name(60, 'm');
  auto plot = make_plot(560, 300);
  origin_below(*plot, {name, "p′ = 70 kPa, e = 1.086"});
  plot->replot();
  const auto svg = to_svg(*plot);
  CHECK(test::contains(svg, ">simulated: " + name + ",<"));
  CHECK(test::contains(svg, ">p′ = 70 kPa, e = 1.086<"));
}
