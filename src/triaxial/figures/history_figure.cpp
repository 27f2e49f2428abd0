#include "src/triaxial/figures/history_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "src/plot/plot_style.hpp"
#include "src/plot/polyline.hpp"
#include "src/triaxial/figures/history_axis.hpp"
#include "src/triaxial/figures/origin_note.hpp"

namespace triax::src {
namespace {

constexpr int kWidth = 620;
constexpr int kPanelHeight = 150;
constexpr int kAxisHeight = 50;
constexpr int kMarkNameHeight = 16;

// A panel shows at least this part of what its quantity did in the whole test: a close view of a
// quantity that is held shall not be filled with the noise of its transducer.
constexpr double kLeastPart = 0.02;

struct Panel {
  std::string title;
  QColor colour;
  std::function<double(const lab::State&)> value;  ///< in the unit of the title
};

bool measured(const study::Curves& curves, const std::function<double(const lab::State&)>& value) {
  for (const auto& state : curves.states)
    if (std::isfinite(value(state))) return true;
  return false;
}

// Along the axial strain a panel of the axial strain would be a straight line.
std::vector<Panel> panels_for(const study::TestResult& test, bool along_time) {
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

void fill_panel(QCPAxisRect& rect, const Panel& panel, const study::TestResult& test,
                const HistoryAxis& axis) {
  auto* graph = add_graph(rect, line(panel.colour, 1.6));
  RangeOf range, whole;
  std::vector<QPointF> points;
  for (const auto& state : test.curves.states) {
    const double value = panel.value(state);
    whole.add(value);
    const auto at = axis.position(state.time_s, state.strain.axial);
    if (!at || !std::isfinite(value)) continue;
    points.emplace_back(*at, value);
    range.add(value);
  }
  range.widen_to(kLeastPart * whole.width());
  rect.axis(QCPAxis::atLeft)->setRange(range.with_margin(0.08, false));

  const QPointF scale(kWidth * axis.unit / (axis.end - axis.begin),
                      kPanelHeight / rect.axis(QCPAxis::atLeft)->range().size());
  auto pixels = points;
  for (auto& point : pixels) point = {point.x() * scale.x(), point.y() * scale.y()};
  for (const auto i : points_to_draw(pixels, kInvisible))
    graph->addData(points[i].x(), points[i].y());
}

// Points of second-order work know their reading and time only; along the strain the strain of that
// reading is looked up between the states that are drawn.
double strain_at(const study::Curves& curves, std::int64_t reading) {
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

void fill_work_panel(QCPAxisRect& rect, const study::TestResult& test, const HistoryAxis& axis,
                     Span span) {
  auto* low = add_graph(rect, Qt::NoPen);
  auto* high = add_graph(rect, Qt::NoPen);
  auto* value = add_graph(rect, line(kPurple, 1.6));
  RangeOf near;
  near.add(0);
  for (const auto& point : test.curves.work) {
    const auto at = axis.position(point.time_s, strain_at(test.curves, point.reading));
    if (!at || !std::isfinite(point.work.normalised)) continue;
    const double error = std::isfinite(point.normalised_error) ? point.normalised_error : 0;
    value->addData(*at, point.work.normalised);
    low->addData(*at, std::max(-1.0, point.work.normalised - error));
    high->addData(*at, std::min(1.0, point.work.normalised + error));
    near.add(point.work.normalised - error);
    near.add(point.work.normalised + error);
  }
  auto band = kPurple;
  band.setAlpha(50);
  high->setBrush(band);
  high->setChannelFillGraph(low);
  const QCPRange all(-1.1, 1.1);
  rect.axis(QCPAxis::atLeft)
      ->setRange(span == Span::onset ? near.with_margin(0.1, false).bounded(-1.1, 1.1) : all);
  rect.axis(QCPAxis::atLeft)->grid()->setZeroLinePen(line(kInk, 1.2));
}

struct Mark {
  double position;  // on the common axis
  std::string name;
  QPen pen;
};

// What deserves a line through all panels, where it lies in the span.
std::vector<Mark> marks_of(const study::TestResult& test, const HistoryAxis& axis) {
  std::vector<Mark> marks;
  const auto add = [&](const std::optional<double>& time_s, const std::optional<double>& strain,
                       const char* name, const QPen& pen) {
    const auto at = axis.position(time_s.value_or(lab::kMissing), strain.value_or(lab::kMissing));
    if (at) marks.push_back({*at, name, pen});
  };
  if (const auto onset = study::collapse_onset(test.stored))
    add(onset->time_s, onset->axial_strain, "onset of collapse",
        line(kVermilion, 1.3, Qt::DashLine));
  if (const auto failure = study::failure_onset(test.stored))
    add(failure->time_s, failure->axial_strain, "failure on the limit surface",
        line(kGrey, 1.3, Qt::DashLine));
  if (const auto& truth = test.stored.summary.truth; truth && truth->lost_sustainability)
    add(truth->time_s, truth->axial_strain, "true onset (model)",
        line(kInk, 1.3, Qt::DotLine));
  return marks;
}

void draw_line(QCPAxisRect& rect, const Mark& mark) {
  auto* item = new QCPItemLine(rect.parentPlot());
  item->setClipAxisRect(&rect);
  item->setPen(mark.pen);
  for (auto* end : {item->start, item->end}) {
    end->setAxisRect(&rect);
    end->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    end->setTypeX(QCPItemPosition::ptPlotCoords);
    end->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  item->start->setCoords(mark.position, 0);
  item->end->setCoords(mark.position, 1);
}

// Names stand above the top panel, each mark's in a row of its own: marks may be close together.
void write_name(QCPAxisRect& top, const Mark& mark, int row) {
  const bool right_half = mark.position > top.axis(QCPAxis::atBottom)->range().center();
  auto* text = new QCPItemText(top.parentPlot());
  text->setClipToAxisRect(false);
  text->setFont(label_font());
  text->setColor(mark.pen.color());
  text->setText(QString::fromStdString(mark.name));
  auto& at = *text->position;
  at.setAxisRect(&top);
  at.setAxes(top.axis(QCPAxis::atBottom), top.axis(QCPAxis::atLeft));
  at.setTypeX(QCPItemPosition::ptPlotCoords);
  at.setTypeY(QCPItemPosition::ptAxisRectRatio);
  at.setCoords(mark.position, 0);
  text->setPadding(QMargins(0, 0, 0, row * kMarkNameHeight + 1));
  text->setPositionAlignment((right_half ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
}

void draw_marks(QCustomPlot& plot, const std::vector<Mark>& marks) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    for (auto* rect : plot.axisRects()) draw_line(*rect, marks[i]);
    write_name(*plot.axisRects().front(), marks[i], static_cast<int>(i));
  }
}

std::string caption(const study::TestResult& test, Span span, bool along_time) {
  auto text = fmt::format("{} of test {} along {}.",
                          span == Span::onset ? "The same around the onset" : "Histories",
                          test.stored.header.name, along_time ? "time" : "axial strain");
  if (span == Span::shear)
    text += " The band around the normalised second-order work is one standard error.";
  return text;
}

// One common axis below; rows are as high as what stands above or below their axes, so that all
// panels come out alike.
void finish_rows(QCustomPlot& plot, const HistoryAxis& axis, int names_height) {
  const auto rects = plot.axisRects();
  for (auto* rect : rects)
    rect->axis(QCPAxis::atBottom)
        ->setRange((axis.begin - axis.origin) / axis.unit, (axis.end - axis.origin) / axis.unit);
  auto* bottom = rects.back()->axis(QCPAxis::atBottom);
  bottom->setTickLabels(true);
  bottom->setLabel(QString::fromStdString(axis.title));
  rects.front()->setMinimumMargins(QMargins(10, 6 + names_height, 16, 6));
  const auto last = static_cast<int>(rects.size()) - 1;
  for (int row = 0; row <= last; ++row)
    plot.plotLayout()->setRowStretchFactor(
        row, kPanelHeight + (row == 0 ? names_height : 0) + (row == last ? kAxisHeight : 0));
}

}  // namespace

Drawing history_figure(const study::TestResult& test, Span span) {
  const auto axis = history_axis(test, span);
  if (!axis) return {};
  const auto panels = panels_for(test, axis->along_time);
  const bool has_work = !test.curves.work.empty();
  const int count = static_cast<int>(panels.size()) + (has_work ? 1 : 0);
  if (count == 0) return {};
  const auto marks = marks_of(test, *axis);
  const int names_height = kMarkNameHeight * static_cast<int>(marks.size());

  auto plot = make_plot(kWidth, count * kPanelHeight + kAxisHeight + names_height + kNoteHeight);
  plot->plotLayout()->clear();
  plot->plotLayout()->setRowSpacing(4);
  auto* margins = new QCPMarginGroup(plot.get());
  for (const auto& panel : panels)
    fill_panel(*add_panel(*plot, margins, panel.title), panel, test, *axis);
  if (has_work) fill_work_panel(*add_panel(*plot, margins, "W₂ normalised (–)"), test, *axis, span);
  finish_rows(*plot, *axis, names_height);
  note_below(*plot, origin_of({&test}));
  draw_marks(*plot, marks);
  return {std::move(plot), caption(test, span, axis->along_time)};
}

}  // namespace triax::src
