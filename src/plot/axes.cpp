// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/axes.hpp"

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

QCPAxisRect& add_axes_beside(QCustomPlot& plot) { return *add_axes_in_rows(plot, 2, 2).back(); }

std::vector<QCPAxisRect*> add_axes_in_rows(QCustomPlot& plot, int count, int columns) {
  std::vector<QCPAxisRect*> all = {plot.axisRect()};
  plot.plotLayout()->take(all.front());
  auto* rows = new QCPLayoutGrid;
  plot.plotLayout()->addElement(0, 0, rows);
  rows->setColumnSpacing(8);
  rows->addElement(0, 0, all.front());
  for (int i = 1; i < count; ++i) {
    auto* next = new QCPAxisRect(&plot);
    rows->addElement(i / columns, i % columns, next);
    for (auto* axis : next->axes()) {
      axis->setLayer("axes");
      axis->grid()->setLayer("grid");
    }
    all.push_back(next);
  }
  return all;
}

}  // namespace triax::src
