#include "src/figures/history_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "src/figures/history_axis.hpp"
#include "src/figures/plot_style.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 620;
constexpr int kPanelHeight = 150;
constexpr int kAxisHeight = 50;

struct Panel {
  std::string title;
  QColor colour;
  std::function<double(const lab::State&)> value;  ///< in the unit of the title
};

bool measured(const Curves& curves, const std::function<double(const lab::State&)>& value) {
  for (const auto& state : curves.states)
    if (std::isfinite(value(state))) return true;
  return false;
}

// Along the axial strain a panel of the axial strain would be a straight line.
std::vector<Panel> panels_for(const ReportedTest& test, bool along_time) {
  const Panel q{"q (kPa)", kBlue, [](const auto& s) { return s.q * 1e-3; }};
  const Panel u{"u (kPa)", kGreen, [](const auto& s) { return s.pore_pressure * 1e-3; }};
  const Panel volume{"ε_v (%)", kGreen, [](const auto& s) { return s.volumetric_strain * 100; }};
  const Panel strain{"ε₁ (%)", kOrange, [](const auto& s) { return s.strain.axial * 100; }};
  std::vector<Panel> panels{q, measured(test.curves, u.value) ? u : volume};
  if (along_time) panels.push_back(strain);
  std::erase_if(panels, [&](const Panel& p) { return !measured(test.curves, p.value); });
  return panels;
}

QCPAxisRect* add_panel(QCustomPlot& plot, QCPMarginGroup* margins, const std::string& title) {
  auto* rect = new QCPAxisRect(&plot, true);
  style_axes(*rect, "", title);
  rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
  rect->setMinimumMargins(QMargins(10, 6, 16, 6));
  rect->axis(QCPAxis::atBottom)->setTickLabels(false);
  rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(4);
  plot.plotLayout()->addElement(plot.plotLayout()->rowCount(), 0, rect);
  return rect;
}

QCPGraph* add_graph(QCPAxisRect& rect, const QPen& pen) {
  auto* plot = rect.parentPlot();
  auto* graph = plot->addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  graph->setPen(pen);
  return graph;
}

void fill_panel(QCPAxisRect& rect, const Panel& panel, const ReportedTest& test,
                const HistoryAxis& axis) {
  auto* graph = add_graph(rect, line(panel.colour, 1.6));
  RangeOf range;
  for (const auto& state : test.curves.states) {
    const double value = panel.value(state);
    const auto at = axis.position(state.time_s, state.strain.axial);
    if (!at || !std::isfinite(value)) continue;
    graph->addData(*at, value);
    range.add(value);
  }
  rect.axis(QCPAxis::atLeft)->setRange(range.with_margin(0.08, false));
}

// Points of second-order work know their reading and time only; along the strain the strain of that
// reading is looked up between the states that are drawn.
double strain_at(const Curves& curves, std::int64_t reading) {
  const auto& states = curves.states;
  const auto next = std::lower_bound(states.begin(), states.end(), reading,
                                     [](const auto& s, auto number) { return s.reading < number; });
  if (next == states.end()) return lab::kMissing;
  if (next->reading == reading || next == states.begin()) return next->strain.axial;
  const auto before = next - 1;
  const double part = static_cast<double>(reading - before->reading) /
                      static_cast<double>(next->reading - before->reading);
  return before->strain.axial + part * (next->strain.axial - before->strain.axial);
}

void fill_work_panel(QCPAxisRect& rect, const ReportedTest& test, const HistoryAxis& axis) {
  auto* low = add_graph(rect, Qt::NoPen);
  auto* high = add_graph(rect, Qt::NoPen);
  auto* value = add_graph(rect, line(kPurple, 1.6));
  for (const auto& point : test.curves.work) {
    const auto at = axis.position(point.time_s, strain_at(test.curves, point.reading));
    if (!at || !std::isfinite(point.work.normalised)) continue;
    const double error = std::isfinite(point.normalised_error) ? point.normalised_error : 0;
    value->addData(*at, point.work.normalised);
    low->addData(*at, std::max(-1.0, point.work.normalised - error));
    high->addData(*at, std::min(1.0, point.work.normalised + error));
  }
  auto band = kPurple;
  band.setAlpha(50);
  high->setBrush(band);
  high->setChannelFillGraph(low);
  rect.axis(QCPAxis::atLeft)->setRange(-1.1, 1.1);
  rect.axis(QCPAxis::atLeft)->grid()->setZeroLinePen(line(kInk, 1.2));
}

void mark_onset(QCustomPlot& plot, double position) {
  for (auto* rect : plot.axisRects()) {
    auto* mark = new QCPItemLine(&plot);
    mark->setClipAxisRect(rect);
    mark->setPen(line(kVermilion, 1.3, Qt::DashLine));
    for (auto* end : {mark->start, mark->end}) {
      end->setAxisRect(rect);
      end->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
      end->setTypeX(QCPItemPosition::ptPlotCoords);
      end->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    mark->start->setCoords(position, 0);
    mark->end->setCoords(position, 1);
  }
  auto* rect = plot.axisRects().front();
  const auto range = rect->axis(QCPAxis::atBottom)->range();
  const bool right_half = position > range.center();
  auto* text = new QCPItemText(&plot);
  text->setClipToAxisRect(false);
  text->setFont(label_font());
  text->setColor(kVermilion);
  text->setText("onset of collapse");
  text->position->setAxisRect(rect);
  text->position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
  text->position->setTypeX(QCPItemPosition::ptPlotCoords);
  text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  text->setPositionAlignment((right_half ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
  text->position->setCoords(position, -0.01);
}

std::string caption(const ReportedTest& test, Span span, bool along_time) {
  auto text = fmt::format("{} of test {} along {}.",
                          span == Span::onset ? "The same around the onset" : "Histories",
                          test.stored.header.name, along_time ? "time" : "axial strain");
  if (span == Span::shear)
    text += " The band around the normalised second-order work is one standard error.";
  return text;
}

}  // namespace

Drawing history_figure(const ReportedTest& test, Span span) {
  const auto axis = history_axis(test, span);
  if (!axis) return {};
  const auto panels = panels_for(test, axis->along_time);
  const bool has_work = !test.curves.work.empty();
  const int count = static_cast<int>(panels.size()) + (has_work ? 1 : 0);
  if (count == 0) return {};

  auto plot = make_plot(kWidth, count * kPanelHeight + kAxisHeight);
  plot->plotLayout()->clear();
  plot->plotLayout()->setRowSpacing(4);
  auto* margins = new QCPMarginGroup(plot.get());
  for (const auto& panel : panels)
    fill_panel(*add_panel(*plot, margins, panel.title), panel, test, *axis);
  if (has_work) fill_work_panel(*add_panel(*plot, margins, "W₂ normalised (–)"), test, *axis);

  for (auto* rect : plot->axisRects())
    rect->axis(QCPAxis::atBottom)
        ->setRange((axis->begin - axis->origin) / axis->unit,
                   (axis->end - axis->origin) / axis->unit);
  auto* top = plot->axisRects().front();
  top->setMinimumMargins(QMargins(10, 22, 16, 6));
  auto* bottom = plot->axisRects().back()->axis(QCPAxis::atBottom);
  bottom->setTickLabels(true);
  bottom->setLabel(QString::fromStdString(axis->title));

  if (const auto& onset = test.stored.summary.collapse.onset) {
    const auto at = axis->position(onset->time_s.value_or(lab::kMissing),
                                   onset->axial_strain.value_or(lab::kMissing));
    if (at) mark_onset(*plot, *at);
  }
  return {std::move(plot), caption(test, span, axis->along_time)};
}

}  // namespace triax::src
