// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/warning_figure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/plot/note.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/triaxial/figures/joined_line.hpp"
#include "src/triaxial/figures/origin_note.hpp"
#include "src/triaxial/figures/panels.hpp"

namespace triax::src {
namespace {

constexpr int kEtaHeight = 280;

QPen measured_pen() { return line(kBlue, 1.6); }

Mark mark_of_warning(const study::WarningMark& mark) {
  using enum study::WarningMarkKind;
  switch (mark.kind) {
    case approaching:
      return {mark.at, "approaching", line(kOrange, 1.3, Qt::DashLine)};
    case imminent:
      return {mark.at, "imminent", line(kPurple, 1.3, Qt::DashLine)};
    case taken_back:
      return {mark.at, "withdrawn", line(kGrey, 1.3, Qt::DashLine)};
    case lost:
      return {mark.at, "lost: known", line(kGreen, 1.3, Qt::DashLine)};
    case onset:
      return {mark.at, "onset of instability", line(kVermilion, 1.3)};
    case failure:
      return {mark.at, "failure, not collapse", line(kGrey, 1.3)};
    case true_onset:
      return {mark.at, "true onset (model)", line(kInk, 1.3, Qt::DotLine)};
  }
  return {};
}

/// What was measured is seen whole, and a forecast as far as it is no wild one.
QCPRange eta_range(const study::WarningHistory& history) {
  RangeOf range;
  range.add(0);
  for (const auto& point : history.eta) range.add(point.value);
  const double most = 1.6 * range.width(), measured_low = range.with_margin(0, true).lower;
  for (const auto& run : history.forecasts)
    for (const auto& point : run)
      range.add(std::clamp(point.eta, measured_low < 0 ? -most : 0.0, most));
  return range.with_margin(0.06, true);
}

void name_curve(QCPLegend& legend, QCPCurve& curve, const char* name) {
  curve.setName(name);
  legend.addItem(new QCPPlottableLegendItem(&legend, &curve));
}

/// Along the axial strain points may go back: they stay in the order of readings.
void draw_points(QCPAxisRect& rect, const std::vector<study::HistoryPoint>& points, double unit) {
  JoinedLine joined;
  for (const auto& point : points) joined.add({point.at, point.value * unit}, point.join);
  draw_joined(rect, joined, measured_pen(), {});
}

QCPCurve* draw_forecast(QCPAxisRect& rect, const std::vector<study::ForecastPoint>& run,
                        const QCPRange& range) {
  // What an axis cuts off on a screen an SVG shows.
  const auto within = [&](double eta) { return std::clamp(eta, range.lower, range.upper); };
  Points band, middle;
  for (const auto& point : run) band.emplace_back(point.at, within(point.low));
  Points back;
  for (const auto& point : run) back.emplace_back(point.at, within(point.high));
  band.insert(band.end(), back.rbegin(), back.rend());
  for (const auto& point : run) middle.emplace_back(point.at, within(point.eta));
  auto fill = kVermilion;
  fill.setAlpha(50);
  lay_behind(*draw_area(rect, band, fill, Qt::NoPen));
  return draw_curve(rect, middle, line(kVermilion, 1.6));
}

void fill_eta_panel(QCPAxisRect& rect, const study::WarningHistory& history) {
  const QCPRange range = eta_range(history);
  rect.axis(QCPAxis::atLeft)->setRange(range);
  auto* legend = new QCPLegend;
  rect.insetLayout()->setMargins(QMargins(6, 6, 6, 6));
  rect.insetLayout()->addElement(legend, Qt::AlignBottom | Qt::AlignRight);
  legend->setLayer("legend");
  style_legend(*legend);
  legend->setBrush(QColor(255, 255, 255, 220));
  QCPCurve* forecast = nullptr;
  for (const auto& run : history.forecasts) forecast = draw_forecast(rect, run, range);
  name_curve(*legend, *forecast, "forecast for the onset, with 90 %");
  draw_points(rect, history.eta, 1);
  name_curve(*legend, *draw_curve(rect, {}, measured_pen()), "measured");
}

void fill_q_panel(QCPAxisRect& rect, const std::vector<study::HistoryPoint>& points) {
  draw_points(rect, points, 1e-3);
  RangeOf range;
  range.add(0);
  for (const auto& point : points) range.add(point.value * 1e-3);
  rect.axis(QCPAxis::atLeft)->setRange(range.with_margin(0.08, true));
}

}  // namespace

Drawing warning_figure(const study::WarningHistory& history) {
  std::vector<Mark> marks;
  for (const auto& mark : history.marks) marks.push_back(mark_of_warning(mark));
  const int names_height = height_of_names(marks);
  auto plot = make_plot(kHistoryWidth,
                        kEtaHeight + kPanelHeight + kAxisHeight + names_height + kNoteHeight);
  plot->plotLayout()->clear();
  plot->setAutoAddPlottableToLegend(false);
  plot->plotLayout()->setRowSpacing(4);
  auto* margins = new QCPMarginGroup(plot.get());
  fill_eta_panel(*add_panel(*plot, margins, "η (–)"), history);
  fill_q_panel(*add_panel(*plot, margins, "q (kPa)"), history.q);
  finish_rows(*plot, history.axis, {kEtaHeight, kPanelHeight}, names_height);
  note_below(*plot, origin_note(history.origin));
  draw_marks(*plot, marks);
  return {std::move(plot),
          fmt::format("The stress ratio of test {} and the forecasts of its onset while it ran, "
                      "with the 90 % interval; broken lines mark warnings.",
                      history.test)};
}

}  // namespace triax::src
