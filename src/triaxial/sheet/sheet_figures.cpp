// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_figures.hpp"

#include <fmt/format.h>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "src/plot/mohr_circles.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"
#include "src/plot/shapes.hpp"
#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = kSheetFigureWidth, kHeight = 240;

QCPScatterStyle failure_marker() {
  return {QCPScatterStyle::ssSquare, line(kInk, 1.6), QBrush(Qt::white), 9};
}
QCPScatterStyle onset_ring() {
  return {QCPScatterStyle::ssCircle, line(kVermilion, 1.6), QBrush(Qt::white), 8};
}

/// Points of one test; a state that is not known is no gap: its neighbours are joined.
Points points_in(const std::vector<lab::State>& states, const SheetAxis& x, const SheetAxis& y) {
  Points points;
  for (const auto& state : states) {
    const QPointF point(x.value(state), y.value(state));
    if (std::isfinite(point.x()) && std::isfinite(point.y())) points.push_back(point);
  }
  return points;
}

class SmallFigure {
 public:
  SmallFigure(const std::string& x, const std::string& y) : plot_(make_plot(kWidth, kHeight)) {
    style_axes(*plot_->axisRect(), x, y);
    for (auto* axis : plot_->axisRect()->axes()) axis->setLabelFont(label_font());
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft})
      plot_->axisRect()->axis(side)->ticker()->setTickCount(5);
    plot_->axisRect()->setMinimumMargins(QMargins(6, 10, 12, 6));
  }
  void take_in(const Points& points) {
    for (const auto& p : points) x_.add(p.x()), y_.add(p.y());
  }
  void take_in_zero(bool x, bool y) {
    if (x) x_.add(0);
    if (y) y_.add(0);
  }
  /// A quantity that is held shall not be filled with the noise of its transducer.
  void widen_y(double least) { y_.widen_to(least); }
  void fix_ranges() {
    plot_->xAxis->setRange(x_.with_margin(0.04, true));
    plot_->yAxis->setRange(y_.with_margin(0.08, true));
  }
  void curve(const Points& points, const QPen& pen) {
    Points pixels = points, kept;
    for (auto& p : pixels)
      p = {p.x() * kWidth / plot_->xAxis->range().size(),
           p.y() * kHeight / plot_->yAxis->range().size()};
    for (const auto i : points_to_draw(pixels, kInvisible)) kept.push_back(points[i]);
    draw_curve(*plot_->axisRect(), kept, pen);
  }
  void marker(const Points& points, const QCPScatterStyle& style) {
    if (!points.empty()) draw_markers(*plot_->axisRect(), points, style);
  }
  QCustomPlot& plot() { return *plot_; }
  OwnPlot take() { return std::move(plot_); }
  bool empty() const { return x_.empty(); }

 private:
  OwnPlot plot_;
  RangeOf x_, y_;
};

std::vector<lab::State> believed(const SheetTest& test, bool shear) {
  const auto last = study::last_believed_reading(test.result.stored);
  std::vector<lab::State> states;
  for (const auto& s : test.result.curves.states)
    if ((!last || s.reading <= *last) &&
        study::is_shear(test.result.stored.header, s.stage) == shear)
      states.push_back(s);
  return states;
}

Points failure_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y) {
  return test.values.failure ? points_in({test.values.failure->state}, x, y) : Points{};
}

/// The state nearest to the onset: the onset itself lacks what figures show beside stresses.
Points onset_in(const SheetTest& test, const SheetAxis& x, const SheetAxis& y) {
  const auto onset = study::collapse_onset(test.result.stored);
  if (!onset || !test.result.stored.state_at_onset) return {};
  return points_in({*test.result.stored.state_at_onset}, x, y);
}

OwnPlot shear_figure(const SheetTest& test, const SheetAxis& x, const SheetAxis& y,
                     double least_height = 0, bool zero_y = true) {
  const auto points = points_in(believed(test, true), x, y);
  if (points.size() < 2) return nullptr;
  SmallFigure figure(x.title, y.title);
  figure.take_in(points);
  figure.take_in_zero(true, zero_y);
  figure.widen_y(least_height);
  figure.fix_ranges();
  figure.curve(points, line(kBlue, 1.8));
  figure.marker(failure_in(test, x, y), failure_marker());
  figure.marker(onset_in(test, x, y), onset_ring());
  return figure.take();
}

OwnPlot path_figure(const SheetTest& test) {
  const auto before = points_in(believed(test, false), p_axis(), q_axis());
  const auto shear = points_in(believed(test, true), p_axis(), q_axis());
  if (shear.size() < 2) return nullptr;
  SmallFigure figure(p_axis().title, q_axis().title);
  figure.take_in(before);
  figure.take_in(shear);
  figure.take_in_zero(true, true);
  figure.fix_ranges();
  figure.curve(before, line(kGrey, 1.2));
  figure.curve(shear, line(kBlue, 1.8));
  figure.marker(failure_in(test, p_axis(), q_axis()), failure_marker());
  figure.marker(onset_in(test, p_axis(), q_axis()), onset_ring());
  return figure.take();
}

OwnPlot consolidation_figure(const SheetTest& test) {
  const auto& curve = test.values.consolidation;
  if (!curve || curve->points.size() < 3) return nullptr;
  const double unit = curve->in_m3 ? 1e6 : 100;
  Points points;
  for (const auto& p : curve->points)
    points.emplace_back(std::sqrt(p.time_s / 60), p.outflow * unit);
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
    write_text(*figure.plot().axisRect(), {at, 0.12 * final}, "√t₁₀₀", kInk, Qt::AlignLeft);
  }
  figure.plot().yAxis->setRangeReversed(true);  // as a settlement is drawn
  return figure.take();
}

OwnPlot void_ratio_figure(const SheetTest& test) {
  const auto before = points_in(believed(test, false), p_axis(), void_ratio_axis());
  const auto shear = points_in(believed(test, true), p_axis(), void_ratio_axis());
  Points all;
  for (const auto* part : {&before, &shear})
    for (const auto& p : *part)
      if (p.x() > 1) all.push_back(p);
  if (all.size() < 2) return nullptr;
  SmallFigure figure("p′ (kPa)", "void ratio e");
  figure.take_in(all);
  figure.widen_y(0.02);
  figure.fix_ranges();
  double low = all.front().x(), high = low;
  for (const auto& p : all) low = std::min(low, p.x()), high = std::max(high, p.x());
  auto& plot = figure.plot();
  plot.xAxis->setScaleType(QCPAxis::stLogarithmic);
  plot.xAxis->setTicker(QSharedPointer<QCPAxisTickerLog>(new QCPAxisTickerLog));
  plot.xAxis->setRange(std::pow(10, std::floor(std::log10(low))),
                       std::pow(10, std::ceil(std::log10(high * 1.001))));
  const auto positive = [](const Points& points) {
    Points out;
    for (const auto& p : points)
      if (p.x() > 1) out.push_back(p);
    return out;
  };
  draw_curve(*plot.axisRect(), positive(before), line(kGrey, 1.2));
  draw_curve(*plot.axisRect(), positive(shear), line(kBlue, 1.8));
  figure.marker(failure_in(test, p_axis(), void_ratio_axis()), failure_marker());
  figure.marker(onset_in(test, p_axis(), void_ratio_axis()), onset_ring());
  return figure.take();
}

/// Value of the curve at x; nothing outside of it.
std::optional<double> value_at(const Points& points, double x) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto &a = points[i - 1], &b = points[i];
    if ((a.x() - x) * (b.x() - x) > 0) continue;
    return b.x() == a.x() ? b.y() : a.y() + (b.y() - a.y()) * (x - a.x()) / (b.x() - a.x());
  }
  return std::nullopt;
}

void draw_band(SmallFigure& figure, const std::vector<Points>& curves) {
  constexpr int kSteps = 80;
  const auto range = figure.plot().xAxis->range();
  Points low, middle, high;
  const auto known = static_cast<std::size_t>(
      std::ranges::count_if(curves, [](const Points& curve) { return curve.size() > 1; }));
  for (int i = 0; i <= kSteps; ++i) {
    const double x = range.lower + range.size() * i / kSteps;
    std::vector<double> values;
    for (const auto& curve : curves)
      if (const auto value = value_at(curve, x)) values.push_back(*value);
    if (2 * values.size() < known) continue;  // of less than half of them no band
    std::ranges::sort(values);
    const auto part = [&](double share) {
      return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
    };
    low.emplace_back(x, part(0.05));
    middle.emplace_back(x, part(0.5));
    high.emplace_back(x, part(0.95));
  }
  Points border = low;
  border.insert(border.end(), high.rbegin(), high.rend());
  auto fill = kBlue;
  fill.setAlpha(50);
  if (!border.empty()) draw_area(*figure.plot().axisRect(), border, fill, Qt::NoPen);
  figure.curve(middle, line(kBlue, 1.8));
}

}  // namespace

SheetAxis axial_strain_axis() {
  return {"ε₁ (%)", [](const lab::State& s) { return s.strain.axial * 100; }};
}
SheetAxis q_axis() {
  return {"q (kPa)", [](const lab::State& s) { return s.q * 1e-3; }};
}
SheetAxis p_axis() {
  return {"p′ (kPa)", [](const lab::State& s) { return s.p_eff * 1e-3; }};
}
SheetAxis u_axis() {
  return {"u (kPa)", [](const lab::State& s) { return s.pore_pressure * 1e-3; }};
}
SheetAxis volumetric_strain_axis() {
  return {"ε_v (%)", [](const lab::State& s) { return s.volumetric_strain * 100; }};
}
SheetAxis eta_axis() {
  // Of stresses that are gone there is no ratio.
  return {"η = q/p′", [](const lab::State& s) {
            constexpr double kGone = 5e3;  // Pa
            return s.p_eff > kGone ? s.eta() : lab::kMissing;
          }};
}
SheetAxis void_ratio_axis() {
  return {"e", [](const lab::State& s) { return s.void_ratio; }};
}

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
  return mohr_part({{"", minor * 1e-3, major * 1e-3}}, std::nullopt, kSheetFigureWidth);
}

SheetPart mohr_part(const std::vector<DrawnCircle>& circles,
                    const std::optional<DrawnEnvelope>& envelope, int width_px) {
  SheetPart part{.plot = make_plot(width_px, kHeight)};
  draw_mohr_circles(*part.plot, circles, envelope);
  for (auto* axis : part.plot->axisRect()->axes()) axis->setLabelFont(label_font());
  part.plot->xAxis->setLabel("σ′ (kPa)");
  part.plot->yAxis->setLabel("τ (kPa)");
  for (auto* axis : {part.plot->xAxis, part.plot->yAxis}) axis->ticker()->setTickCount(4);
  part.settle = [circles, envelope](QCustomPlot& plot) {
    scale_mohr_circles(plot, circles, envelope);
  };
  return part;
}

void name_total_stress(QCustomPlot& plot) { plot.xAxis->setLabel("σ (kPa)"); }

OwnPlot total_stress_figure(const std::vector<const SheetTest*>& tests) {
  return set_figure(tests, axial_strain_axis(), q_axis());
}

OwnPlot set_figure(const std::vector<const SheetTest*>& tests, const SheetAxis& x,
                   const SheetAxis& y) {
  std::vector<Points> curves;
  SmallFigure figure(x.title, y.title);
  for (const auto* test : tests) {
    curves.push_back(points_in(believed(*test, true), x, y));
    figure.take_in(curves.back());
  }
  if (figure.empty()) return nullptr;
  figure.take_in_zero(true, false);
  figure.fix_ranges();
  if (tests.size() > kMostCurves && x.title == axial_strain_axis().title) {
    draw_band(figure, curves);
  } else {
    const bool many = tests.size() > kMostCurves;
    for (std::size_t i = 0; i < curves.size(); ++i)
      figure.curve(curves[i], many ? line(QColor(0, 0x72, 0xB2, 70), 1) : curve_pen(i, 1.5));
  }
  for (const auto* test : tests) {
    if (tests.size() > kMostCurves) break;
    figure.marker(failure_in(*test, x, y), failure_marker());
    figure.marker(onset_in(*test, x, y), onset_ring());
  }
  return figure.take();
}

}  // namespace triax::src
