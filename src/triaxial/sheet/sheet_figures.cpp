// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/plot/mohr_circles.hpp"
#include "src/study/triaxial/shear_series.hpp"
#include "src/triaxial/sheet/sheet_axes.hpp"
#include "src/triaxial/sheet/small_figure.hpp"

namespace triax::src {
namespace {

OwnPlot shear_figure(const SheetTest& test, const SheetAxis& x, const SheetAxis& y,
                     double least_height = 0, bool zero_y = true) {
  const auto curve = line_in(test, believed(test, true), x, y);
  if (curve.points.size() < 2) return nullptr;
  SmallFigure figure(x.title, y.title);
  figure.take_in(curve.points);
  figure.take_in_zero(true, zero_y);
  figure.widen_y(least_height);
  figure.fix_ranges();
  figure.curve(curve, line(kBlue, 1.8));
  figure.marker(failure_in(test, x, y), failure_marker());
  figure.marker(onset_in(test, x, y), onset_ring());
  figure.marker(loss_of_control_in(test, x, y), loss_of_control_diamond());
  return figure.take();
}

OwnPlot path_figure(const SheetTest& test) {
  const auto before = line_in(test, believed(test, false), p_axis(), q_axis());
  const auto shear = line_in(test, believed(test, true), p_axis(), q_axis());
  if (shear.points.size() < 2) return nullptr;
  SmallFigure figure(p_axis().title, q_axis().title);
  figure.take_in(before.points);
  figure.take_in(shear.points);
  figure.take_in_zero(true, true);
  figure.fix_ranges();
  figure.curve(before, line(kGrey, 1.2));
  figure.curve(shear, line(kBlue, 1.8));
  figure.marker(failure_in(test, p_axis(), q_axis()), failure_marker());
  figure.marker(onset_in(test, p_axis(), q_axis()), onset_ring());
  figure.marker(loss_of_control_in(test, p_axis(), q_axis()), loss_of_control_diamond());
  return figure.take();
}

OwnPlot consolidation_figure(const SheetTest& test) {
  const auto& curve = test.values.consolidation;
  const auto points = consolidation_points(test);
  if (points.empty()) return nullptr;
  const double unit = curve->in_m3 ? 1e6 : 100;
  SmallFigure figure("√t (√min), consolidation", curve->in_m3 ? "water out (cm³)" : "ε_v (%)");
  figure.take_in(points);
  figure.take_in_zero(true, true);
  figure.fix_ranges();
  figure.curve(points, line(kBlue, 1.8));
  if (const auto& fit = curve->fit) {
    const double at = std::sqrt(fit->t100_s / 60), final = fit->final * unit;
    draw_curve(*figure.plot().axisRect(), {{0, fit->zero * unit}, {at, final}},
               line(kInk, 1, Qt::DashLine));
    draw_curve(*figure.plot().axisRect(), {{at, final}, {at, 0}}, line(kInk, 1, Qt::DotLine));
    write_text(*figure.plot().axisRect(), {at, 0.12 * final}, "\u2009√t₁₀₀", kInk, Qt::AlignLeft);
  }
  figure.plot().yAxis->setRangeReversed(true);  // as a settlement is drawn
  return figure.take();
}

OwnPlot void_ratio_figure(const SheetTest& test) {
  const auto x = p_axis(), y = void_ratio_axis();
  const auto before = loaded(line_in(test, believed(test, false), x, y));
  const auto shear = loaded(line_in(test, believed(test, true), x, y));
  Points all = before.points;
  all.insert(all.end(), shear.points.begin(), shear.points.end());
  if (all.size() < 2) return nullptr;
  SmallFigure figure(x.title, y.title);
  figure.take_in(all);
  figure.widen_y(0.02);
  figure.fix_log_ranges(all);
  figure.curve(before, line(kGrey, 1.2));
  figure.curve(shear, line(kBlue, 1.8));
  figure.marker(failure_in(test, x, y), failure_marker());
  figure.marker(onset_in(test, x, y), onset_ring());
  figure.marker(loss_of_control_in(test, x, y), loss_of_control_diamond());
  return figure.take();
}

}  // namespace

std::vector<SheetFigure> sheet_figures(const SheetTest& test) {
  const bool drained = test.values.drainage == lab::Drainage::open;
  const std::string name = test.result.stored.header.name;
  std::vector<SheetFigure> figures;
  const auto add = [&](const char* file, const char* what, OwnPlot plot) {
    if (plot)
      figures.push_back({file, {std::move(plot), fmt::format("{} of test {}.", what, name)}});
  };
  const auto strain = axial_strain_axis();
  add("consolidation", "Consolidation over the root of time", consolidation_figure(test));
  add("q", "Deviator stress over axial strain", shear_figure(test, strain, q_axis()));
  if (test.result.stored.header.is_total_stress()) return figures;
  OwnPlot u = drained ? nullptr : shear_figure(test, strain, u_axis(), 1, false);
  if (u)
    add("u", "Pore pressure over axial strain", std::move(u));
  else if (test.values.drainage == lab::Drainage::closed)  // p′ tells what u would
    add("p", "Mean effective stress over axial strain", shear_figure(test, strain, p_axis()));
  else
    add("volume", "Volumetric strain over axial strain",
        shear_figure(test, strain, volumetric_strain_axis(), 0.1));
  add("eta", "Stress ratio over axial strain", shear_figure(test, strain, eta_axis(), 0.05));
  add("path", "Effective stress path", path_figure(test));
  add("void_ratio", "Void ratio over mean effective stress", void_ratio_figure(test));
  return figures;
}

SheetPart circle_part(const SheetTest& test) {
  if (!test.values.failure) return {};
  const auto& s = test.values.failure->state.effective_stress;
  const double major = std::max(s.axial, s.radial), minor = std::min(s.axial, s.radial);
  if (!(major > minor)) return {};
  auto part = mohr_part({{"", minor * 1e-3, major * 1e-3}}, std::nullopt, kSheetFigureWidth);
  for (auto* axis : {part.plot->xAxis, part.plot->yAxis}) axis->ticker()->setTickCount(2);
  return part;
}

SheetPart mohr_part(const std::vector<DrawnCircle>& circles,
                    const std::optional<DrawnEnvelope>& envelope, int width_px,
                    const QString& stress) {
  SheetPart part{.plot = make_plot(width_px, kSmallFigureHeight)};
  draw_mohr_circles(*part.plot, circles, envelope);
  for (auto* axis : part.plot->axisRect()->axes()) axis->setLabelFont(label_font());
  part.plot->xAxis->setLabel(stress);
  part.plot->yAxis->setLabel("τ (kPa)");
  for (auto* axis : {part.plot->xAxis, part.plot->yAxis}) axis->ticker()->setTickCount(4);
  part.settle = [circles, envelope](QCustomPlot& plot) {
    scale_mohr_circles(plot, circles, envelope);
  };
  return part;
}

}  // namespace triax::src
