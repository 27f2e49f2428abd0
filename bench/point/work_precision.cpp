// SPDX-License-Identifier: GPL-3.0-or-later
// bench_work_precision [FILE.svg|FILE.png]: error of a path against its time for each law, by
// tolerance, as a table and as a diagram (dots: pair of high order, circles: of low order).
// Undrained compression of 2 % in one increment, so that the integrator alone chooses its steps;
// error against the same path with a tolerance of 1e-13.
#include <fmt/format.h>

#include "bench/point/yardstick.hpp"
#include "lab/materials/material_library.hpp"
#include "sim/point/point_driver.hpp"
#include "src/output/output.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/plot_style.hpp"

using namespace triax;

namespace {

constexpr int kDrawn = 6;

struct Point {
  double tolerance, error, microseconds;
};

template <class Space>
std::vector<Point> measure(const sim::Law<Space>& law) {
  const auto start = law.isotropic(100e3, 0.95);
  const auto control = sim::MixedControl<Space>::strain_path(0.02);
  const auto exact = sim::advance_point(law, start, control, {.relative = 1e-13});
  std::vector<Point> points;
  for (double tolerance = 1e-3; tolerance > 1e-12; tolerance /= 10) {
    const sim::PointTolerance settings{.relative = tolerance};
    const auto found = sim::advance_point(law, start, control, settings);
    if (found.outcome != sim::StepOutcome::accepted) continue;
    const double error =
        (found.state.stress - exact.state.stress).norm() / exact.state.stress.norm();
    const double seconds =
        bench::least_seconds(20, [&] { return sim::advance_point(law, start, control, settings); });
    points.push_back({tolerance, std::max(error, 1e-16), seconds * 1e6});
    fmt::print("{:>8.0e} {:>12.2e} {:>10.1f} {:>7}\n", tolerance, error, seconds * 1e6,
               found.steps);
  }
  return points;
}

void draw(QCustomPlot& plot, const std::string& name, const std::vector<Point>& points, int index) {
  static const QColor kColours[] = {src::kBlue,   src::kVermilion, src::kGreen, src::kOrange,
                                    src::kPurple, src::kInk,       src::kGrey};
  auto* pair_of_high_order = plot.addGraph();
  pair_of_high_order->setName(QString::fromStdString(name));
  pair_of_high_order->setPen(src::line(kColours[index % 7]));
  pair_of_high_order->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 5));
  auto* pair_of_low_order = plot.addGraph();
  pair_of_low_order->setPen(src::line(kColours[index % 7]));
  pair_of_low_order->setLineStyle(QCPGraph::lsNone);
  pair_of_low_order->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, 6));
  pair_of_low_order->removeFromLegend();
  for (const Point& p : points)
    (&sim::tableau_for(p.tolerance) == &sim::kDormandPrince ? pair_of_high_order
                                                            : pair_of_low_order)
        ->addData(p.microseconds, p.error);
}

}  // namespace

int main(int argc, char** argv) {
  const auto plot = src::make_plot(760, 520);
  src::style_axes(*plot->axisRect(), "time per path (µs)", "relative error of the stress at 2 %");
  plot->axisRect()->setMinimumMargins({0, 10, 20, 0});
  for (auto* axis : {plot->xAxis, plot->yAxis}) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    axis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    axis->setNumberFormat("eb");
    axis->setNumberPrecision(0);
  }
  int index = 0;
  for (const char* name : {"cam_clay/Hostun-like", "hypoplastic/HG99", "sanisand/S28-general",
                           "norsand/S28-MT", "inl2/S28-general", "octolinear/S28-general"}) {
    const auto set = lab::find_material(name);
    fmt::print("\n{}, axisymmetric\n{:>8} {:>12} {:>10} {:>7}\n", name, "tol", "error", "us/path",
               "steps");
    const auto points = measure(*set.material.axisymmetric);
    // The simple laws at the end are exact but for round-off: a line along the bottom.
    if (index < kDrawn) draw(*plot, name, points, index++);
  }
  plot->rescaleAxes();
  plot->xAxis->scaleRange(1.2);
  plot->yAxis->scaleRange(1.2);
  plot->legend->setVisible(true);
  src::style_legend(*plot->legend);
  src::legend_below(*plot, 3);
  if (argc < 2) return 0;
  const std::string file = argv[1];
  src::write_file(file, file.ends_with(".png") ? src::to_png(*plot, 1.5) : src::to_svg(*plot));
}
