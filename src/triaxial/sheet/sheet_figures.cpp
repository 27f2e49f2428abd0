// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sheet/sheet_figures.hpp"

#include <fmt/format.h>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "src/plot/log_axis.hpp"
#include "src/plot/mohr_circles.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"
#include "src/plot/shapes.hpp"
#include "src/study/triaxial/shear_series.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = kSheetFigureWidth, kHeight = 240;
// A step that is this part of the figure's diagonal, and so many times as long as the mean of the
// others, is no curve that was read.
constexpr double kLongStep = 0.25, kTimesOthers = 8;

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

/// Numbers of those points, in pixels, to which the specimen ran away from the point before.
std::vector<std::size_t> ends_of_long_steps(const Points& pixels) {
  std::vector<double> steps;
  double all = 0;
  for (std::size_t i = 1; i < pixels.size(); ++i) {
    const auto way = pixels[i] - pixels[i - 1];
    all += steps.emplace_back(std::hypot(way.x(), way.y()));
  }
  std::vector<std::size_t> ends;
  if (steps.size() < 3) return ends;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i] > kLongStep * std::hypot(kWidth, kHeight) &&
        steps[i] * static_cast<double>(steps.size() - 1) > kTimesOthers * (all - steps[i]))
      ends.push_back(i + 1);
  return ends;
}

/// Those with a logarithm that matters, of p′ in kPa.
Points loaded(const Points& points) {
  Points out;
  for (const auto& p : points)
    if (p.x() > 1) out.push_back(p);
  return out;
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
  void fix_log_ranges(const Points& points) {
    fix_ranges();
    double low = points.front().x(), high = low;
    for (const auto& p : points) low = std::min(low, p.x()), high = std::max(high, p.x());
    set_log_axis(*plot_->xAxis, low, high);
  }
  /// Of a long step nobody read what was between: it is dotted.
  void curve(const Points& points, const QPen& pen, bool dotted_steps = true) {
    Points pixels;
    for (const auto& p : points) pixels.push_back(in_pixels(p));
    std::size_t from = 0;
    const auto stretch = [&](std::size_t end) {
      Points kept;
      const Points part(pixels.begin() + static_cast<std::ptrdiff_t>(from),
                        pixels.begin() + static_cast<std::ptrdiff_t>(end));
      for (const auto i : points_to_draw(part, kInvisible)) kept.push_back(points[from + i]);
      if (kept.size() > 1) draw_curve(*plot_->axisRect(), kept, pen);
      from = end;
    };
    const auto ends = dotted_steps ? ends_of_long_steps(pixels) : std::vector<std::size_t>{};
    for (const auto end : ends) {
      stretch(end);
      draw_curve(*plot_->axisRect(), {points[end - 1], points[end]},
                 line(pen.color(), 1, Qt::DotLine));
    }
    stretch(points.size());
  }
  void marker(const Points& points, const QCPScatterStyle& style) {
    if (!points.empty()) draw_markers(*plot_->axisRect(), points, style);
  }
  QCustomPlot& plot() { return *plot_; }
  OwnPlot take() { return std::move(plot_); }
  bool empty() const { return x_.empty(); }

 private:
  QPointF in_pixels(const QPointF& p) const {
    const auto part = [](const QCPAxis& axis, double value) {
      const auto range = axis.range();
      return axis.scaleType() == QCPAxis::stLogarithmic
                 ? std::log(value / range.lower) / std::log(range.upper / range.lower)
                 : value / range.size();
    };
    return {kWidth * part(*plot_->xAxis, p.x()), kHeight * part(*plot_->yAxis, p.y())};
  }

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
    write_text(*figure.plot().axisRect(), {at, 0.12 * final}, "\u2009√t₁₀₀", kInk, Qt::AlignLeft);
  }
  figure.plot().yAxis->setRangeReversed(true);  // as a settlement is drawn
  return figure.take();
}

OwnPlot void_ratio_figure(const SheetTest& test) {
  const auto x = p_axis(), y = void_ratio_axis();
  const auto before = loaded(points_in(believed(test, false), x, y));
  const auto shear = loaded(points_in(believed(test, true), x, y));
  Points all = before;
  all.insert(all.end(), shear.begin(), shear.end());
  if (all.size() < 2) return nullptr;
  SmallFigure figure(x.title, y.title);
  figure.take_in(all);
  figure.widen_y(0.02);
  figure.fix_log_ranges(all);
  figure.curve(before, line(kGrey, 1.2));
  figure.curve(shear, line(kBlue, 1.8));
  figure.marker(failure_in(test, x, y), failure_marker());
  figure.marker(onset_in(test, x, y), onset_ring());
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

/// What holds nine of ten curves at each x, and the median.
struct Band {
  Points low, middle, high;
};

Band band_of(const std::vector<Points>& curves) {
  constexpr int kSteps = 120;
  RangeOf x_range;
  for (const auto& curve : curves)
    for (const auto& p : curve) x_range.add(p.x());
  const auto range = x_range.with_margin(0, true);
  Band band;
  const auto known = static_cast<std::size_t>(
      std::ranges::count_if(curves, [](const Points& curve) { return curve.size() > 1; }));
  for (int i = 0; i <= kSteps; ++i) {
    // Closer at the beginning, where most of a test happens.
    const double share = static_cast<double>(i) / kSteps;
    const double x = range.lower + range.size() * share * share;
    std::vector<double> values;
    for (const auto& curve : curves)
      if (const auto value = value_at(curve, x)) values.push_back(*value);
    if (2 * values.size() < known) continue;  // of less than half of them no band
    std::ranges::sort(values);
    const auto part = [&](double of_all) {
      return values[static_cast<std::size_t>(
          std::lround(of_all * static_cast<double>(values.size() - 1)))];
    };
    band.low.emplace_back(x, part(0.05));
    band.middle.emplace_back(x, part(0.5));
    band.high.emplace_back(x, part(0.95));
  }
  return band;
}

OwnPlot band_figure(const std::vector<Points>& curves, const SheetAxis& x, const SheetAxis& y) {
  const auto band = band_of(curves);
  if (band.middle.size() < 2) return nullptr;
  SmallFigure figure(x.title, y.title);
  figure.take_in(band.low);
  figure.take_in(band.high);
  figure.take_in_zero(true, false);
  figure.fix_ranges();
  Points border = band.low;
  border.insert(border.end(), band.high.rbegin(), band.high.rend());
  auto fill = kBlue;
  fill.setAlpha(50);
  draw_area(*figure.plot().axisRect(), border, fill, Qt::NoPen);
  figure.curve(band.middle, line(kBlue, 1.8));
  return figure.take();
}

/// Shear of a test as a set draws it; empty where the plane has nothing to say of it.
Points curve_of_set(const SheetTest& test, const SheetAxis& x, const SheetAxis& y, bool as_band) {
  const auto states = believed(test, true);
  const bool strains = y.title == volumetric_strain_axis().title;
  // Closed, its volume is the same by decree; of cycles there is no value at a strain.
  if (strains &&
      study::drainage_of_shear(test.result.stored.header, states) == lab::Drainage::closed)
    return {};
  if (as_band && test.result.stored.summary.cyclic) return {};
  const auto points = points_in(states, x, y);
  return y.title == void_ratio_axis().title ? loaded(points) : points;
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

std::vector<std::size_t> drawn_of_many(std::size_t count) {
  constexpr double kMostDrawn = 60, kGolden = 0.6180339887498949;
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = kGolden * static_cast<double>(i);
    if (place - std::floor(place) < kMostDrawn / static_cast<double>(count)) drawn.push_back(i);
  }
  return drawn;
}

OwnPlot set_figure(const std::vector<const SheetTest*>& tests, const SheetAxis& x,
                   const SheetAxis& y) {
  const bool many = tests.size() > kMostCurves;
  const bool as_band = many && x.title == axial_strain_axis().title;
  std::vector<Points> curves;
  Points all;
  for (const auto* test : tests) {
    const auto& points = curves.emplace_back(curve_of_set(*test, x, y, as_band));
    all.insert(all.end(), points.begin(), points.end());
  }
  if (all.size() < 2) return nullptr;
  if (as_band) return band_figure(curves, x, y);
  SmallFigure figure(x.title, y.title);
  figure.take_in(all);
  if (y.title == void_ratio_axis().title) {
    figure.widen_y(0.02);
    figure.fix_log_ranges(all);
  } else {
    figure.take_in_zero(true, false);
    figure.fix_ranges();
  }
  for (const std::size_t i : drawn_of_many(curves.size()))
    figure.curve(curves[i], many ? line(QColor(0, 0x72, 0xB2, 70), 1) : curve_pen(i, 1.5), !many);
  for (std::size_t i = 0; i < curves.size() && !many; ++i) {
    if (curves[i].empty()) continue;
    figure.marker(failure_in(*tests[i], x, y), failure_marker());
    figure.marker(onset_in(*tests[i], x, y), onset_ring());
  }
  return figure.take();
}

}  // namespace triax::src
