#include "src/figures/axes.hpp"

#include <algorithm>

namespace triax::src {

void set_equal_ranges(QCPAxisRect& rect, const QCPRange& x, const QCPRange& y) {
  auto* across = rect.axis(QCPAxis::atBottom);
  auto* up = rect.axis(QCPAxis::atLeft);
  across->setRange(x);
  up->setRange(y);
  // The numbers beside the axes take room that depends on the ranges.
  for (int pass = 0; pass < 3; ++pass) {
    rect.parentPlot()->replot();
    const double unit = std::min(rect.width() / x.size(), rect.height() / y.size());
    if (!(unit > 0)) return;
    across->setRange(x.center(), rect.width() / unit, Qt::AlignCenter);
    up->setRange(y.center(), rect.height() / unit, Qt::AlignCenter);
  }
}

void hide_axes(QCPAxisRect& rect) {
  for (auto* axis : rect.axes()) {
    axis->setVisible(false);
    axis->grid()->setVisible(false);
  }
}

QCPAxisRect& add_axes_beside(QCustomPlot& plot) {
  auto* own = plot.axisRect();
  plot.plotLayout()->take(own);
  auto* row = new QCPLayoutGrid;
  plot.plotLayout()->addElement(0, 0, row);
  row->setColumnSpacing(8);
  row->addElement(0, 0, own);
  auto* beside = new QCPAxisRect(&plot);
  row->addElement(0, 1, beside);
  for (auto* axis : beside->axes()) {
    axis->setLayer("axes");
    axis->grid()->setLayer("grid");
  }
  return *beside;
}

}  // namespace triax::src
